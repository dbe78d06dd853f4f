// SPDX-License-Identifier: MIT
// The report in a real browser, headless: its script runs without an error, keys and pointer do what the page
// says, and nothing is asked of a network.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "image/image_io.hpp"
#include "report_sample.hpp"
#include "support/patterns.hpp"
#include "support/run_program.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

const fs::path chromium = "/usr/bin/chromium";

class ReportBrowser : public testing::Test {
protected:
    ReportBrowser() { report::writeReportFolder(folder, sampleCases(), sampleHeading()); }

    void SetUp() override {
        ASSERT_TRUE(fs::exists(chromium)) << "a browser is missing; install the Debian package chromium";
    }

    // Runs the browser on a page in `folder`. What it may reach is this machine's files: every host name is
    // unknown.
    ProgramResult browse(const std::string& page, std::vector<std::string> options) const {
        options.insert(
            options.end(),
            {"--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-sync",
             "--disable-extensions", "--disable-component-update", "--disable-background-networking",
             "--disable-dev-shm-usage", "--hide-scrollbars", "--force-device-scale-factor=1",
             "--host-resolver-rules=MAP * ~NOTFOUND", "--virtual-time-budget=10000",
             "--user-data-dir=" + (folder / "profile").string(), "file://" + (folder / page).string()});
        const ProgramResult result = runProgram(chromium, options);
        fs::remove_all(folder / "profile");
        return result;
    }

    // The page as it stands when its script, and then ours, has run.
    std::string domAfter(const std::string& script) const {
        std::string html = fileText(folder / "index.html");
        html.insert(html.rfind("</body>"), "<script>\n" + script + "</script>\n");
        writeText(folder / "scripted.html", html);
        const ProgramResult result = browse("scripted.html", {"--dump-dom"});
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return result.out;
    }

    // What the page, or our script, has written to the root's attribute "data-<name>".
    static std::string dataOf(const std::string& dom, const std::string& name) {
        const std::string start = dom.substr(0, std::min<std::size_t>(dom.size(), 20000));
        const auto found = matchesIn(start, "<html[^>]* data-" + name + "=\"([^\"]*)\"");
        return found.empty() ? "(none)" : found[0][1];
    }

    fs::path folder = scratchFolder();
};

TEST_F(ReportBrowser, IsReadyWithoutAnError) {
    const std::string dom = domAfter("");
    EXPECT_EQ(dataOf(dom, "ready"), fmt::format("{}", sampleCases().size()));
    EXPECT_EQ(dataOf(dom, "errors"), "(none)");
    EXPECT_NE(dom.find(fmt::format(">{0} of {0}</output>", sampleCases().size())), std::string::npos);
}

TEST_F(ReportBrowser, AnErrorOfTheScriptIsSeen) {
    const std::string dom = domAfter("setTimeout(() => planted(), 0);");
    EXPECT_NE(dataOf(dom, "errors").find("planted is not defined"), std::string::npos);
}

// Helpers of the scripts below: by keys and pointer alone, as a person would.
constexpr const char* hands = R"js(
const caseOf = name => cases.find(shown => shown.querySelector('h2').textContent === name);
const press = (target, key) => target.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
const type = text => { filter.value = text; filter.dispatchEvent(new Event('input', { bubbles: true })); };
const tell = (name, value) => { root.dataset[name] = value; };
const names = () => visible().map(shown => shown.querySelector('h2').textContent).join(' ');
)js";

TEST_F(ReportBrowser, FiltersByTextAndByFailure) {
    const std::string dom = domAfter(std::string(hands) + R"js(
tell('all', names());
press(document.body, '/');
tell('focus', document.activeElement.id);
type('SEAM differ');
tell('found', names());
type('no such words');
tell('none', names() + '!' + document.querySelector('#none').hidden);
press(filter, 'Escape');
tell('again', visible().length);
press(document.body, 'f');
tell('failing', names());
)js");
    EXPECT_EQ(dataOf(dom, "errors"), "(none)");
    // Failed ones first, what was not compared before what was, then by how far it is off.
    EXPECT_EQ(dataOf(dom, "all"), "hole shifted nan small lost spindle checker far thin fat ring");
    EXPECT_EQ(dataOf(dom, "focus"), "filter");
    EXPECT_EQ(dataOf(dom, "found"), "checker");
    EXPECT_EQ(dataOf(dom, "none"), "!false");
    EXPECT_EQ(dataOf(dom, "again"), fmt::format("{}", sampleCases().size()));
    EXPECT_EQ(dataOf(dom, "failing"), "hole shifted nan small lost spindle checker far");
}

TEST_F(ReportBrowser, MovesTheMarkAndTheCommandThatExplainsIt) {
    const std::string dom = domAfter(std::string(hands) + R"js(
const far = caseOf('far');
far.open = true;
const picture = far.querySelector('.picture.actual');
const command = () => far.querySelector('code').textContent;
tell('worst', command());
const box = picture.getBoundingClientRect();
const click = (x, y) => picture.dispatchEvent(new MouseEvent('click', { bubbles: true, detail: 1,
  clientX: box.left + (x + .5) * box.width / 48, clientY: box.top + (y + .5) * box.height / 32 }));
click(3, 30);
tell('picked', command() + ' ' + far.querySelector('.place').textContent);
for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft', 'ArrowDown', 'ArrowDown', 'ArrowUp']) press(picture, key);
tell('moved', command());
const square = picture.querySelector('.mark').getBoundingClientRect();
tell('mark', Math.round((square.left - box.left) / box.width * 48) + ' ' + Math.round((square.top - box.top) / box.height * 32));
)js");
    EXPECT_EQ(dataOf(dom, "errors"), "(none)");
    EXPECT_TRUE(isLike(dataOf(dom, "worst"),
                       "raytorus explain --scene 'my \\{x\\},\\{y\\}/far.json' --pixel [0-9]+,[0-9]+"))
        << dataOf(dom, "worst");
    EXPECT_EQ(dataOf(dom, "picked"), "raytorus explain --scene 'my {x},{y}/far.json' --pixel 3,30 (3, 30)");
    EXPECT_EQ(dataOf(dom, "moved"), "raytorus explain --scene 'my {x},{y}/far.json' --pixel 0,30");
    EXPECT_EQ(dataOf(dom, "mark"), "0 30");
}

TEST_F(ReportBrowser, SplitsAmplifiesAndEnlarges) {
    const std::string dom = domAfter(std::string(hands) + R"js(
const hole = caseOf('hole');
const slider = hole.querySelector('.split input');
slider.value = 25;
slider.dispatchEvent(new Event('input', { bubbles: true }));
tell('split', getComputedStyle(hole.querySelector('.split .actual')).clipPath);
const boxOf = selector => JSON.stringify(hole.querySelector(selector).getBoundingClientRect());
tell('covers', (boxOf('.split .actual') === boxOf('.split')) + ' ' + (boxOf('.split input') === boxOf('.split')));
const gain = hole.querySelector('.gain');
gain.value = 64;
gain.dispatchEvent(new Event('input', { bubbles: true }));
tell('gain', getComputedStyle(hole.querySelector('.amplified'), '::before').filter + ' ' +
  caseOf('ring').querySelector('.gain').value);
hole.querySelector('.picture.expected').dispatchEvent(new MouseEvent('click', { bubbles: true, detail: 0 }));
tell('large', dialog.open + ' ' + kind + ' ' +
  (getComputedStyle(large).backgroundImage === getComputedStyle(hole.querySelector('.picture.expected')).backgroundImage));
press(dialog, 'ArrowLeft');
tell('next', kind + ' ' + getComputedStyle(large).backgroundImage.startsWith('url("data:image/png;base64,'));
large.click();
tell('closed', dialog.open);
press(document.body, 'j');
press(document.activeElement, 'j');
press(document.activeElement, 'k');
press(document.activeElement, 'j');
tell('second', document.activeElement.closest('.case').querySelector('h2').textContent);
location.hash = '#far';
addEventListener('hashchange', () => tell('linked', caseOf('far').open));
)js");
    EXPECT_EQ(dataOf(dom, "errors"), "(none)");
    EXPECT_EQ(dataOf(dom, "split"), "inset(0px 0px 0px 25%)");
    EXPECT_EQ(dataOf(dom, "covers"), "true true");
    EXPECT_EQ(dataOf(dom, "gain"), "brightness(64) 64");
    EXPECT_EQ(dataOf(dom, "large"), "true expected true");
    EXPECT_EQ(dataOf(dom, "next"), "margin true");
    EXPECT_EQ(dataOf(dom, "closed"), "false");
    EXPECT_EQ(dataOf(dom, "second"), "shifted");
    EXPECT_EQ(dataOf(dom, "linked"), "true");
}

// docs/images/report.png is the light one of these.
TEST_F(ReportBrowser, IsDrawn) {
    struct Look {
        std::string file;
        std::string page;
        std::vector<std::string> options;
        int background;
    };
    const std::vector<Look> looks = {
        {"light.png", "index.html#far", {}, 0xf5},
        {"dark.png", "index.html", {"--blink-settings=preferredColorScheme=0"}, 0x14}};
    for (const Look& look : looks) {
        std::vector<std::string> options = look.options;
        options.insert(options.end(),
                       {"--screenshot=" + (folder / look.file).string(), "--window-size=1180,2080"});
        const ProgramResult result = browse(look.page, options);
        ASSERT_TRUE(fs::exists(folder / look.file)) << result.err;
        const image::Image picture = image::readImage(folder / look.file);
        EXPECT_EQ(picture.width, 1180);
        EXPECT_EQ(picture.height, 2080);
        // The page's own background in the corner, and much else elsewhere.
        EXPECT_NEAR(picture.pixel(0, 0)[0], look.background / 255.0, 0.01) << look.file;
        std::vector<float> reds;
        for (std::size_t i = 0; i < picture.pixels.size(); i += picture.channelNames.size()) {
            reds.push_back(picture.pixels[i]);
        }
        std::ranges::sort(reds);
        const auto shades = std::ranges::unique(reds).begin() - reds.begin();
        EXPECT_GT(shades, 100) << look.file;
    }
}

}  // namespace
}  // namespace raytorus::test
