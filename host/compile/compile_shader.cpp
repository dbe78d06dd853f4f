// SPDX-License-Identifier: MIT
#include "compile/compile_shader.hpp"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>

#include "compile/large_stack.hpp"

namespace raytorus::compile {
namespace {

// glslang's tables, made once and kept to the end: they are what makes the first compilation slow.
bool initializeGlslang() {
    static const bool done = glslang::InitializeProcess();
    return done;
}

std::optional<EShLanguage> stageOf(const std::filesystem::path& entry) {
    const std::string extension = entry.extension().string();
    if (extension == ".vert") {
        return EShLangVertex;
    }
    if (extension == ".frag") {
        return EShLangFragment;
    }
    return extension == ".comp" ? std::optional(EShLangCompute) : std::nullopt;
}

// Hands glslang what the search finds. glslang is compiled without exceptions: none may pass through it.
class Includer : public glslang::TShader::Includer {
public:
    explicit Includer(IncludeSearch& where) : search(where) {}

    IncludeResult* includeLocal(const char* name, const char* /*includer*/, std::size_t depth) override {
        try {
            IncludeSearch::Found found = search.find(name, depth);
            if (found.source != nullptr) {
                const std::string& text = found.source->text;
                return new IncludeResult(logName(found.id), text.data(), text.size(), nullptr);
            }
            pending = std::move(found.refusal);
        } catch (...) {
            thrown = std::current_exception();
        }
        return nullptr;
    }

    // Asked for #include <...>, and once more for what was just refused: this answer reaches the log.
    IncludeResult* includeSystem(const char* /*name*/, const char* /*includer*/,
                                 std::size_t /*depth*/) override {
        try {
            refusals.push_back(pending.empty() ? "#include <...> is not known here, write #include \"...\""
                                               : pending);
            pending.clear();
            reasons.push_back(logRefusal(refusals.size() - 1));
            return new IncludeResult("", reasons.back().data(), reasons.back().size(), nullptr);
        } catch (...) {
            thrown = std::current_exception();
            return nullptr;
        }
    }

    void releaseInclude(IncludeResult* result) override { delete result; }

    std::vector<std::string> refusals;
    std::exception_ptr thrown;

private:
    IncludeSearch& search;
    std::string pending;
    std::deque<std::string> reasons;
};

std::string problemOf(const Define& define) {
    const auto isNameCharacter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    const bool isName = !define.name.empty() &&
                        std::isdigit(static_cast<unsigned char>(define.name[0])) == 0 &&
                        std::all_of(define.name.begin(), define.name.end(), isNameCharacter);
    if (!isName) {
        return fmt::format("\"{}\" is no name of a macro", define.name);
    }
    if (define.value.find_first_of("\n\r\\") != std::string::npos ||
        define.value.find('\0') != std::string::npos) {
        return fmt::format("the value of the macro {} is not one line", define.name);
    }
    return {};
}

std::string preambleOf(const std::vector<Define>& defines) {
    std::string preamble;
    for (const Define& define : defines) {
        preamble += fmt::format("#define {} {}\n", define.name, define.value);
    }
    return preamble;
}

void compileWithGlslang(EShLanguage stage, const ShaderRequest& request, IncludeSearch& search,
                        CompiledShader& result) {
    // What glslangValidator sets for --target-env vulkan1.3.
    constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    constexpr int versionOfVulkanGlsl = 100;
    constexpr int versionWithoutDirective = 100;

    const std::string preamble = preambleOf(request.defines);
    const Source& entry = search.sources().front();
    const std::string name = logName(0);
    const std::array texts{entry.text.c_str()};
    const std::array lengths{static_cast<int>(entry.text.size())};
    const std::array names{name.c_str()};

    glslang::TShader shader(stage);  // must outlive the program
    shader.setStringsWithLengthsAndNames(texts.data(), lengths.data(), names.data(), 1);
    shader.setPreamble(preamble.c_str());
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, versionOfVulkanGlsl);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    Includer includer(search);
    const bool parsed =
        shader.parse(GetDefaultResources(), versionWithoutDirective, false, messages, includer);
    if (includer.thrown) {
        std::rethrow_exception(includer.thrown);
    }
    std::string log = shader.getInfoLog();
    glslang::TProgram program;
    program.addShader(&shader);
    const bool linked = parsed && program.link(messages) && program.mapIO();
    if (linked) {
        glslang::GlslangToSpv(*program.getIntermediate(stage), result.words);
        return;
    }
    if (parsed) {
        log += program.getInfoLog();
    }
    result.errors = readLog(log, search, includer.refusals);
    if (result.errors.empty()) {
        result.errors.push_back({entry.name, 0, "glslang refuses this shader and gives no reason"});
    }
}

void compile(const ShaderRequest& request, IncludeSearch& search, CompiledShader& result) {
    const std::string& name = search.sources().front().name;
    const std::optional<EShLanguage> stage = stageOf(request.entry);
    if (!stage) {
        result.errors.push_back(
            {name, 0, "the stage is not known: .vert, .frag or .comp must end the file's name"});
    } else if (!search.entryProblem().empty()) {
        result.errors.push_back({name, 0, "cannot read this shader: " + search.entryProblem()});
    }
    for (const Define& define : request.defines) {
        if (std::string problem = problemOf(define); !problem.empty()) {
            result.errors.push_back({name, 0, std::move(problem)});
        }
    }
    if (!result.ok()) {
        return;
    }
    if (!initializeGlslang()) {
        result.errors.push_back({name, 0, "glslang does not start"});
        return;
    }
    compileWithGlslang(*stage, request, search, result);
}

}  // namespace

CompiledShader compileShader(const ShaderRequest& request) {
    // glslang has locks of its own around its tables; that its other parts need none is nowhere promised.
    static std::mutex oneAtATime;
    const std::scoped_lock lock(oneAtATime);
    CompiledShader result;
    std::exception_ptr thrown;
    IncludeSearch search(request.entry, request.roots, request.virtualIncludes);
    runWithLargeStack([&] {
        try {
            compile(request, search, result);
        } catch (...) {
            thrown = std::current_exception();
        }
    });
    if (thrown) {
        std::rethrow_exception(thrown);
    }
    result.files = search.files();
    return result;
}

std::string describe(const CompileError& error) {
    return error.line > 0 ? fmt::format("{}:{}: {}", error.file, error.line, error.text)
                          : fmt::format("{}: {}", error.file, error.text);
}

}  // namespace raytorus::compile
