// SPDX-License-Identifier: MIT
#include "mutate/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/json_text.hpp"

namespace raytorus::mutate {
namespace {

// "camera r/R 0.9 D/R 3: 2 of ...": what caught it, without the numbers behind the colon.
std::string nameOfCheck(const std::string& caught) {
    return caught.substr(0, caught.find(':'));
}

std::string cell(const SuiteVerdict& verdict, const char* notAsked) {
    if (!verdict.asked) {
        return notAsked;
    }
    return verdict.caught ? nameOfCheck(*verdict.caught) : "-";
}

const char* goldensNotAsked(const Outcome& outcome) {
    return outcome.mutation.shows == Shows::InNumbers ? "(not in pictures)" : "(same code)";
}

nlohmann::ordered_json jsonOf(const SuiteVerdict& verdict) {
    nlohmann::ordered_json json = {{"asked", verdict.asked}, {"caughtBy", nullptr}};
    if (verdict.caught) {
        json["caughtBy"] = *verdict.caught;
    }
    return json;
}

}  // namespace

Totals totalsOf(std::span<const Outcome> outcomes) {
    Totals totals;
    for (const Outcome& outcome : outcomes) {
        ++totals.all;
        totals.caught += outcome.caught() ? 1 : 0;
        totals.caughtByNumbers += outcome.numbers.caught ? 1 : 0;
        totals.inPictures += outcome.mutation.shows == Shows::InPictures ? 1 : 0;
        totals.caughtByGoldens += outcome.goldens.caught ? 1 : 0;
        totals.caughtByBits += outcome.bits ? 1 : 0;
    }
    return totals;
}

std::string headText() {
    return fmt::format("{:<32}{:<32}{:<32}{}\n", "mutation", "goldens", "their bits on a CPU",
                       "numeric tests");
}

std::string rowText(const Outcome& outcome) {
    return fmt::format("{:<32}{:<32}{:<32}{}{}\n", outcome.mutation.name,
                       cell(outcome.goldens, goldensNotAsked(outcome)), outcome.bits.value_or("-"),
                       cell(outcome.numbers, "(same code)"), outcome.caught() ? "" : "  SURVIVED");
}

std::string totalsText(const Totals& totals) {
    const auto share = [](int part, int whole) { return whole > 0 ? 100.0 * part / whole : 100.0; };
    return fmt::format(
        "goldens alone: {} of the {} faults that pictures can show ({:.1f} %; {:.1f} % of all); their bits: "
        "{}\n"
        "numeric tests alone: {} of all {} ({:.1f} %)\n"
        "both: {} of {} ({:.1f} %)",
        totals.caughtByGoldens, totals.inPictures, share(totals.caughtByGoldens, totals.inPictures),
        share(totals.caughtByGoldens, totals.all), totals.caughtByBits, totals.caughtByNumbers, totals.all,
        share(totals.caughtByNumbers, totals.all), totals.caught, totals.all,
        share(totals.caught, totals.all));
}

std::string outcomesMarkdown(std::span<const Outcome> outcomes) {
    std::string text =
        "# Faults, and what catches them\n\n"
        "Written by `raytorus-mutate --markdown`: [how sharp the tests "
        "are](testing.md#how-sharp-they-are).\n\n"
        "| Fault | What somebody got wrong | Goldens | Their bits on a CPU | Numeric tests |\n"
        "|---|---|---|---|---|\n";
    for (const Outcome& outcome : outcomes) {
        text += fmt::format("| {} | {} | {} | {} | {} |\n", outcome.mutation.name, outcome.mutation.mistake,
                            cell(outcome.goldens, goldensNotAsked(outcome)), outcome.bits.value_or("-"),
                            cell(outcome.numbers, "(same code)"));
    }
    return fmt::format("{}\n```\n{}\n```\n", text, totalsText(totalsOf(outcomes)));
}

std::string outcomesJson(std::span<const Outcome> outcomes) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Outcome& outcome : outcomes) {
        rows.push_back({{"name", outcome.mutation.name},
                        {"file", outcome.mutation.file},
                        {"mistake", outcome.mutation.mistake},
                        {"inPictures", outcome.mutation.shows == Shows::InPictures},
                        {"goldens", jsonOf(outcome.goldens)},
                        {"goldenBits", outcome.bits ? nlohmann::ordered_json(*outcome.bits) : nullptr},
                        {"numbers", jsonOf(outcome.numbers)}});
    }
    const Totals totals = totalsOf(outcomes);
    const nlohmann::ordered_json json = {{"mutations", rows},
                                         {"totals",
                                          {{"all", totals.all},
                                           {"caught", totals.caught},
                                           {"caughtByNumbers", totals.caughtByNumbers},
                                           {"inPictures", totals.inPictures},
                                           {"caughtByGoldens", totals.caughtByGoldens},
                                           {"caughtByBits", totals.caughtByBits}}},
                                         {"thresholdHeld", totals.thresholdHeld()}};
    return dumpJson(json) + "\n";
}

}  // namespace raytorus::mutate
