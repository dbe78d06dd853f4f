// SPDX-License-Identifier: MIT
#include "cli/picture_writer.hpp"

namespace raytorus::cli {

PictureWriter::PictureWriter(std::size_t most, Write write)
    : capacity(most), writePicture(std::move(write)), thread([this] { run(); }) {}

PictureWriter::~PictureWriter() {
    {
        const std::scoped_lock lock(mutex);
        waiting.clear();
        stopping = true;
    }
    changed.notify_all();
}

// With the mutex held.
void PictureWriter::rethrow() {
    if (failure) {
        std::rethrow_exception(failure);
    }
}

void PictureWriter::write(std::filesystem::path path, image::Image picture) {
    {
        std::unique_lock lock(mutex);
        changed.wait(lock, [this] { return waiting.size() < capacity || failure; });
        rethrow();
        waiting.push_back({std::move(path), std::move(picture)});
    }
    changed.notify_all();
}

void PictureWriter::finish() {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return (waiting.empty() && !writing) || failure; });
    rethrow();
}

void PictureWriter::run() {
    std::unique_lock lock(mutex);
    while (true) {
        changed.wait(lock, [this] { return !waiting.empty() || stopping; });
        if (waiting.empty() || failure) {
            return;
        }
        const Job job = std::move(waiting.front());
        waiting.pop_front();
        writing = true;
        lock.unlock();
        changed.notify_all();
        std::exception_ptr problem;
        try {
            writePicture(job.path, job.picture);
        } catch (...) {
            problem = std::current_exception();
        }
        lock.lock();
        writing = false;
        failure = problem;
        changed.notify_all();
    }
}

}  // namespace raytorus::cli
