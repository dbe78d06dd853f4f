// SPDX-License-Identifier: MIT
// Pipelines are made once, ahead and in other threads where that is asked for, and what goes wrong comes back
// to whoever wants them.
#include "render/pipeline_store.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/error.hpp"
#include "support/expect_error.hpp"
#include "support/semaphore.hpp"

namespace raytorus::render {
namespace {

// Makes pipelines of nothing, and counts them.
struct Maker {
    PipelineStore::Make make() {
        return [this] {
            ++made;
            madeHere = madeHere || std::this_thread::get_id() == here;
            return gpu::Pipeline();
        };
    }
    PipelineStore::Make broken() {
        return [this]() -> gpu::Pipeline {
            ++made;
            throw Error(ExitCode::Shader, "the driver refuses the shader");
        };
    }
    const std::thread::id here = std::this_thread::get_id();
    std::atomic<int> made = 0;
    std::atomic<bool> madeHere = false;
};

TEST(PipelineStore, MakesEachOnce) {
    Maker maker;
    PipelineStore store;
    const gpu::Pipeline* first = &store.find(Route::Fragment, {1, 2}, maker.make());
    EXPECT_EQ(&store.find(Route::Fragment, {1, 2}, maker.make()), first);
    EXPECT_NE(&store.find(Route::Compute, {1, 2}, maker.make()), first);
    EXPECT_NE(&store.find(Route::Fragment, {1, 3}, maker.make()), first);
    EXPECT_EQ(maker.made, 3);
    EXPECT_EQ(store.size(), 3U);
}

TEST(PipelineStore, WhatIsPreparedIsMadeOnceByAnotherThread) {
    Maker maker;
    PipelineStore store;
    for (std::uint32_t k = 0; k < 50; ++k) {
        store.prepare(Route::Fragment, {k}, maker.make());
        store.prepare(Route::Fragment, {k}, maker.make());
    }
    for (std::uint32_t k = 0; k < 50; ++k) {
        const gpu::Pipeline* found = &store.find(Route::Fragment, {k}, maker.broken());
        EXPECT_EQ(&store.find(Route::Fragment, {k}, maker.broken()), found);
        store.prepare(Route::Fragment, {k}, maker.broken());
    }
    EXPECT_EQ(maker.made, 50);
    EXPECT_FALSE(maker.madeHere);
    EXPECT_EQ(store.size(), 50U);
}

TEST(PipelineStore, PreparingDoesNotWait) {
    Maker maker;
    test::Semaphore go;
    PipelineStore store;
    store.prepare(Route::Fragment, {1}, [&] {
        go.acquire();
        return maker.make()();
    });
    store.find(Route::Compute, {1}, maker.make());
    EXPECT_EQ(maker.made, 1);
    go.release();
    store.find(Route::Fragment, {1}, maker.broken());
    EXPECT_EQ(maker.made, 2);
}

TEST(PipelineStore, WhatGoesWrongIsThrownWhenThePipelineIsWanted) {
    Maker maker;
    PipelineStore store;
    store.prepare(Route::Fragment, {1}, maker.broken());
    store.prepare(Route::Fragment, {2}, maker.make());
    store.find(Route::Fragment, {2}, maker.broken());
    test::expectError([&] { store.find(Route::Fragment, {1}, maker.make()); }, ExitCode::Shader, {"refuses"});
    store.find(Route::Fragment, {1}, maker.make());
    EXPECT_EQ(maker.made, 3);
}

TEST(PipelineStore, WhatIsBeingMadeEndsBeforeTheStoreGoes) {
    Maker maker;
    test::Semaphore begun;
    {
        PipelineStore store;
        store.prepare(Route::Fragment, {1}, [&] {
            begun.release();
            std::this_thread::sleep_for(std::chrono::milliseconds(20));  // for the store to go meanwhile
            return maker.make()();
        });
        begun.acquire();
    }
    EXPECT_EQ(maker.made, 1);
}

}  // namespace
}  // namespace raytorus::render
