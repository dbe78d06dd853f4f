// SPDX-License-Identifier: MIT
#include "viewer/commands.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace raytorus::viewer {
namespace {

auto waitsFor(Moment moment) {
    return [moment](const Command& command) {
        return std::visit([](const auto& which) { return which.moment; }, command) == moment;
    };
}

}  // namespace

void CommandQueue::push(Command command) {
    if (std::holds_alternative<TakeApart>(command)) {
        std::erase_if(waiting, [](const Command& other) { return std::holds_alternative<TakeApart>(other); });
    }
    waiting.push_back(std::move(command));
}

bool CommandQueue::waits(Moment moment) const {
    return std::ranges::any_of(waiting, waitsFor(moment));
}

std::vector<Command> CommandQueue::take(Moment moment) {
    const auto later = std::ranges::stable_partition(waiting, waitsFor(moment)).begin();
    std::vector<Command> taken(std::make_move_iterator(waiting.begin()), std::make_move_iterator(later));
    waiting.erase(waiting.begin(), later);
    return taken;
}

}  // namespace raytorus::viewer
