// SPDX-License-Identifier: MIT
// raytorus-golden: lists the golden cases, and renews those that are named, for a reason that is kept beside
// them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file.hpp"
#include "golden_check.hpp"
#include "gpu/validation.hpp"
#include "image/image_io.hpp"

namespace raytorus::test {
namespace {

const GoldenCase& findCase(const std::string& name) {
    const auto* found = std::find_if(goldenCases.begin(), goldenCases.end(),
                                     [&name](const GoldenCase& row) { return name == row.name; });
    if (found == goldenCases.end()) {
        throw Error(ExitCode::Usage,
                    fmt::format("no golden case is called \"{}\" (see raytorus-golden list)", name));
    }
    return *found;
}

void list() {
    for (const GoldenCase& row : goldenCases) {
        fmt::print("{:<10}{}\n", row.name, row.catches);
    }
}

void renew(const std::vector<std::string>& names, const std::string& reason) {
    if (std::getenv("CI") != nullptr) {
        throw Error(ExitCode::Usage, "goldens are renewed by people, not in CI");
    }
    std::vector<GoldenCase> rows;
    std::transform(names.begin(), names.end(), std::back_inserter(rows), findCase);
    const auto log = std::make_shared<gpu::ValidationLog>();
    gpu::ContextOptions options;
    options.validate = true;
    gpu::Context context(options, log);
    for (const GoldenCase& row : rows) {
        const image::Image picture = renderGolden(context, row, render::Route::Fragment);
        if (!image::compare(picture, renderGolden(context, row, render::Route::Compute), {}).passed()) {
            throw Error(ExitCode::ComparisonFailed,
                        fmt::format("{}: the two routes disagree, so neither becomes a golden", row.name));
        }
        log->requireEmpty();
        const std::filesystem::path folder = std::filesystem::path(RAYTORUS_SOURCE_DIR) / "golden";
        image::writeImage(folder / fmt::format("{}.exr", row.name), picture);
        const nlohmann::ordered_json provenance = {{"case", row.name},
                                                   {"catches", row.catches},
                                                   {"reason", reason},
                                                   {"device", context.info().name},
                                                   {"driver", context.info().driverInfo},
                                                   {"raytorus", version()}};
        const std::string text = provenance.dump(2) + "\n";
        writeFile(folder / fmt::format("{}.json", row.name), std::as_bytes(std::span(text)));
        fmt::print("renewed golden/{}.exr\n", row.name);
    }
}

int run(int argc, char** argv) {
    CLI::App app("Golden pictures of raytorus: list them, renew them.", "raytorus-golden");
    app.require_subcommand(1);
    app.footer("Example:\n  raytorus-golden renew ring --reason \"the checker has 40 fields now\"");
    CLI::App* listing = app.add_subcommand("list", "The cases, and what each is there to catch");
    CLI::App* renewal = app.add_subcommand("renew", "Render the named cases anew and write them to golden/");
    std::vector<std::string> names;
    std::string reason;
    renewal->add_option("cases", names, "Names of cases")->required()->option_text("CASE...");
    renewal->add_option("--reason", reason, "Why; kept beside the golden")->required()->option_text("TEXT");
    CLI11_PARSE(app, argc, argv);
    if (*listing) {
        list();
    } else {
        renew(names, reason);
    }
    return 0;
}

}  // namespace
}  // namespace raytorus::test

int main(int argc, char** argv) {
    try {
        return raytorus::test::run(argc, argv);
    } catch (const raytorus::Error& error) {
        fmt::print(stderr, "raytorus-golden: {}\n", error.what());
        return static_cast<int>(error.exitCode);
    }
}
