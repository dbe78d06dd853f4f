// SPDX-License-Identifier: MIT
#include "mutate/mutation_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "core/error.hpp"
#include "mutate/mutant.hpp"

namespace raytorus::mutate {
namespace {

// A device of its own: what a mutant does to one is no other's business. Messages of the validation layers,
// if they run, are errors.
template <class Work>
void onDevice(const RunOptions& options, const Work& work) {
    const auto log = std::make_shared<gpu::ValidationLog>();
    {
        gpu::Context context(options.device, log);
        work(context);
    }
    log->requireEmpty();
}

Outcome outcomeOf(const Mutation& mutation, GoldenSuite& goldens, const RunOptions& options) {
    const Mutant mutant(&mutation, options.folder / mutation.name);
    Outcome outcome{mutation, {}, {}, {}};
    outcome.goldens.asked =
        mutation.shows == Shows::InPictures && (mutant.changes("scene.frag") || mutant.changes("scene.comp"));
    const Asked asked{mutant.changes("trace.comp"), mutant.changesFast(), mutant.changes("probe.comp"),
                      mutant.changes("scene.frag")};
    outcome.numbers.asked = asked.any();
    if (!outcome.goldens.asked && !outcome.numbers.asked) {
        throw Error(ExitCode::Internal,
                    fmt::format("mutation {}: no shader that a suite runs is changed", mutation.name));
    }
    onDevice(options, [&](gpu::Context& context) {
        if (outcome.goldens.asked) {
            const GoldenVerdict verdict = goldens.caught(context, mutant.shaders());
            outcome.goldens.caught = verdict.truth;
            outcome.bits = verdict.bits;
        }
        if (outcome.numbers.asked) {
            outcome.numbers.caught = caughtByNumbers(context, mutant, options.rays, asked);
        }
    });
    return outcome;
}

}  // namespace

void requireUnchangedPasses(GoldenSuite& goldens, const RunOptions& options) {
    const Mutant unchanged(nullptr, options.folder / "unchanged");
    onDevice(options, [&](gpu::Context& context) {
        const GoldenVerdict pictures = goldens.caught(context, unchanged.shaders());
        for (const auto& caught :
             {pictures.truth, pictures.bits, caughtByNumbers(context, unchanged, options.rays)}) {
            if (caught) {
                throw Error(ExitCode::Internal,
                            fmt::format("the unchanged shaders are caught by {}", *caught));
            }
        }
    });
}

std::vector<Outcome> runMutations(std::span<const Mutation> mutations, GoldenSuite& goldens,
                                  const RunOptions& options) {
    std::vector<std::optional<Outcome>> found(mutations.size());
    std::vector<Outcome> outcomes;  // reported
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        for (std::size_t i = next++; i < mutations.size(); i = next++) {
            try {
                Outcome outcome = outcomeOf(mutations[i], goldens, options);
                const std::scoped_lock lock(mutex);
                found[i] = std::move(outcome);
                while (outcomes.size() < found.size() && found[outcomes.size()]) {
                    outcomes.push_back(*found[outcomes.size()]);
                    if (options.report) {
                        options.report(outcomes.back());
                    }
                }
            } catch (...) {
                const std::scoped_lock lock(mutex);
                failure = failure ? failure : std::current_exception();
                next = mutations.size();
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        const unsigned jobs =
            options.jobs > 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
        for (unsigned i = 0; i < jobs; ++i) {
            threads.emplace_back(work);
        }
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
    return outcomes;
}

}  // namespace raytorus::mutate
