// SPDX-License-Identifier: MIT
#include "window_display.hpp"

#include <fmt/format.h>
#include <xcb/xcb.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

#include "window_process.hpp"

namespace raytorus::test {
namespace {

constexpr const char* xvfb = "/usr/bin/Xvfb";
constexpr const char* xdotool = "/usr/bin/xdotool";

template <typename Reply>
using Owned = std::unique_ptr<Reply, decltype(&std::free)>;

template <typename Reply>
Owned<Reply> own(Reply* reply, const char* request) {
    if (reply == nullptr) {
        throw std::runtime_error(fmt::format("the display refuses {}", request));
    }
    return {reply, &std::free};
}

xcb_atom_t atom(xcb_connection_t* connection, const std::string& name) {
    const auto cookie = xcb_intern_atom(connection, 0, static_cast<std::uint16_t>(name.size()), name.c_str());
    return own(xcb_intern_atom_reply(connection, cookie, nullptr), "an atom")->atom;
}

}  // namespace

std::optional<std::string> missingForWindows() {
    std::string missing;
    for (const auto& [program, package] : {std::pair(xvfb, "xvfb"), std::pair(xdotool, "xdotool")}) {
        if (!std::filesystem::exists(program)) {
            missing += fmt::format(" {}", package);
        }
    }
    if (missing.empty()) {
        return std::nullopt;
    }
    return "windows cannot be tested; install the Debian packages" + missing;
}

struct Display::Server {
    // -noreset: the server stays as it is when the last window has gone. -r: a key that is held is one press.
    explicit Server(const std::filesystem::path& errors)
        : process(xvfb, {"-displayfd", "1", "-screen", "0", "1280x1024x24", "-noreset", "-r"}, {}, errors) {
        const std::optional<std::string> number = process.readLine();
        if (!number) {
            throw std::runtime_error("Xvfb does not start: " + process.errorText());
        }
        name = ":" + *number;
        connection = xcb_connect(name.c_str(), nullptr);
        if (xcb_connection_has_error(connection) != 0) {
            throw std::runtime_error("the display cannot be connected to: " + name);
        }
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    ~Server() { xcb_disconnect(connection); }

    // As window managers tell a window about itself.
    void setState(std::uint32_t window, std::uint32_t state) const {
        const xcb_atom_t property = atom(connection, "WM_STATE");
        const std::array<std::uint32_t, 2> value = {state, XCB_NONE};
        xcb_change_property(connection, XCB_PROP_MODE_REPLACE, window, property, property, 32, 2,
                            value.data());
    }

    LiveProcess process;
    std::string name;
    xcb_connection_t* connection = nullptr;
};

Display::Display(const std::filesystem::path& errors)
    : server(std::make_unique<Server>(errors)), displayName(server->name) {}

Display::~Display() = default;

std::string Display::hand(const std::vector<std::string>& words) const {
    ProgramSettings settings;
    settings.environment = {{"DISPLAY", displayName}};
    const ProgramResult result = runProgram(xdotool, words, settings);
    if (result.exitCode != 0) {
        throw std::runtime_error(
            fmt::format("xdotool {} ends with {}: {}", fmt::join(words, " "), result.exitCode, result.err));
    }
    return result.out;
}

std::uint32_t Display::window() const {
    return static_cast<std::uint32_t>(
        std::stoul(hand({"search", "--sync", "--onlyvisible", "--name", "raytorus"})));
}

void Display::askToClose(std::uint32_t window) const {
    xcb_client_message_event_t message{};
    message.response_type = XCB_CLIENT_MESSAGE;
    message.format = 32;
    message.window = window;
    message.type = atom(server->connection, "WM_PROTOCOLS");
    message.data.data32[0] = atom(server->connection, "WM_DELETE_WINDOW");
    message.data.data32[1] = XCB_CURRENT_TIME;
    xcb_send_event(server->connection, 0, window, XCB_EVENT_MASK_NO_EVENT,
                   reinterpret_cast<const char*>(&message));
    xcb_flush(server->connection);
}

void Display::minimise(std::uint32_t window) const {
    constexpr std::uint32_t iconic = 3;
    xcb_unmap_window(server->connection, window);
    server->setState(window, iconic);
    xcb_flush(server->connection);
}

void Display::restore(std::uint32_t window) const {
    constexpr std::uint32_t normal = 1;
    server->setState(window, normal);
    xcb_map_window(server->connection, window);
    xcb_flush(server->connection);
}

image::Image Display::capture(std::uint32_t window) const {
    xcb_connection_t* connection = server->connection;
    const auto size =
        own(xcb_get_geometry_reply(connection, xcb_get_geometry(connection, window), nullptr), "a size");
    const auto cookie = xcb_get_image(connection, XCB_IMAGE_FORMAT_Z_PIXMAP, window, 0, 0, size->width,
                                      size->height, ~std::uint32_t{0});
    const auto reply = own(xcb_get_image_reply(connection, cookie, nullptr), "a picture");
    const std::uint8_t* bytes = xcb_get_image_data(reply.get());  // blue, green, red and one that is unused
    image::Image picture(size->width, size->height, {"R", "G", "B"});
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] = static_cast<float>(bytes[i / 3 * 4 + 2 - i % 3]) / 255.0F;
    }
    return picture;
}

}  // namespace raytorus::test
