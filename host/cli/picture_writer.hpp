// SPDX-License-Identifier: MIT
// Writes pictures in a thread of its own, while the next one is rendered.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>

#include "image/image.hpp"

namespace raytorus::cli {

class PictureWriter {
public:
    using Write = std::function<void(const std::filesystem::path&, const image::Image&)>;

    /// Holds at most so many pictures besides the one that is being written. `write` is called in the
    /// writer's thread, and is image::writeImage but in tests.
    explicit PictureWriter(std::size_t capacity, Write write);
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;
    /// Waits for the picture that is being written. Those after it are dropped unless finish() was called.
    ~PictureWriter();

    /// Takes a picture over, and waits while there is no room. Throws what writing an earlier one threw.
    void write(std::filesystem::path path, image::Image picture);

    /// Waits until all are written. Throws what writing one threw; those after it are not written.
    void finish();

private:
    struct Job {
        std::filesystem::path path;
        image::Image picture;
    };

    void run();
    void rethrow();

    std::size_t capacity;
    Write writePicture;
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<Job> waiting;
    bool writing = false;
    bool stopping = false;
    std::exception_ptr failure;
    std::jthread thread;  // last: it starts when all else is there
};

}  // namespace raytorus::cli
