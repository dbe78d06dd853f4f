// SPDX-License-Identifier: MIT
#include "compile/compile_shader.hpp"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <shared_mutex>
#include <utility>

#include "core/parse_number.hpp"

namespace raytorus::compile {
namespace {

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

void setUp(glslang::TShader& shader, EShLanguage stage) {
    // What glslangValidator sets for --target-env vulkan1.3.
    constexpr int versionOfVulkanGlsl = 100;
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, versionOfVulkanGlsl);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
}

constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
constexpr int versionWithoutDirective = 100;

// The tables of a stage and a version, which glslang makes at its first shader of them and keeps to the end.
// Made here, of a shader that is known to be none of the bad ones, they are there in each child.
class Tables {
public:
    // Until the lock is given back no table is made: in a child, what another thread was at would never end.
    std::shared_lock<std::shared_mutex> of(EShLanguage stage, const Source& entry) {
        const auto key = std::pair(stage, versionOf(entry));
        {
            std::shared_lock shared(mutex);
            if (made.contains(key)) {
                return shared;
            }
        }
        {
            const std::unique_lock alone(mutex);
            static const bool started = glslang::InitializeProcess();
            if (started && made.insert(key).second) {
                const std::string text = fmt::format("#version {}\nvoid main() {{}}\n", key.second);
                const char* const texts = text.c_str();
                glslang::TShader shader(stage);
                shader.setStrings(&texts, 1);
                setUp(shader, stage);
                shader.parse(GetDefaultResources(), versionWithoutDirective, false, messages);
            }
        }
        return std::shared_lock(mutex);
    }

private:
    static int versionOf(const Source& entry) {
        constexpr int usual = 460;
        for (const Directive& directive : entry.directives) {
            if (directive.keyword == "version") {
                return parseNumber<int>(directive.rest).value_or(usual);
            }
        }
        return usual;
    }

    std::shared_mutex mutex;
    std::set<std::pair<EShLanguage, int>> made;
};

// What the child process tells: which of these, then strings, numbers or words.
enum class Message : char { File, Error, Words };

class Writer {
public:
    explicit Writer(Message what) : text(1, static_cast<char>(what)) {}

    void bytes(const void* from, std::size_t size) { text.append(static_cast<const char*>(from), size); }
    void string(std::string_view value) {
        const std::size_t size = value.size();
        bytes(&size, sizeof size);
        bytes(value.data(), size);
    }

    std::string text;
};

class Reader {
public:
    explicit Reader(std::string_view message) : rest(message.substr(1)) {}

    void bytes(void* to, std::size_t size) {
        std::memcpy(to, rest.data(), size);
        rest.remove_prefix(size);
    }
    std::string string() {
        std::size_t size = 0;
        bytes(&size, sizeof size);
        std::string value(rest.substr(0, size));
        rest.remove_prefix(size);
        return value;
    }

    std::string_view rest;
};

void tellError(const Tell& tell, const CompileError& error) {
    Writer writer(Message::Error);
    writer.string(error.file);
    writer.bytes(&error.line, sizeof error.line);
    writer.string(error.text);
    tell(writer.text);
}

void hear(std::string_view message, CompiledShader& result) {
    Reader reader(message);
    switch (static_cast<Message>(message.front())) {
        case Message::File: {
            std::filesystem::path path = reader.string();
            result.files.push_back({std::move(path), reader.string()});
            break;
        }
        case Message::Error: {
            CompileError& error = result.errors.emplace_back();
            error.file = reader.string();
            reader.bytes(&error.line, sizeof error.line);
            error.text = reader.string();
            break;
        }
        case Message::Words:
            result.words.resize(reader.rest.size() / sizeof result.words[0]);
            reader.bytes(result.words.data(), reader.rest.size());
            break;
    }
}

// Hands glslang what the search finds. glslang is compiled without exceptions: none may pass through it.
class Includer : public glslang::TShader::Includer {
public:
    Includer(IncludeSearch& where, const Tell& toParent)
        : search(where), tell(toParent), told(where.files().size()) {}

    IncludeResult* includeLocal(const char* name, const char* /*includer*/,
                                std::size_t depth) noexcept override {
        IncludeSearch::Found found = search.find(name, depth);
        tellFiles();
        if (found.source != nullptr) {
            const std::string& text = found.source->text;
            return new IncludeResult(logName(found.id), text.data(), text.size(), nullptr);
        }
        pending = std::move(found.refusal);
        return nullptr;
    }

    // Asked for #include <...>, and once more for what was just refused: this answer reaches the log.
    IncludeResult* includeSystem(const char* /*name*/, const char* /*includer*/,
                                 std::size_t /*depth*/) noexcept override {
        refusals.push_back(pending.empty() ? "#include <...> is not known here, write #include \"...\""
                                           : pending);
        pending.clear();
        reasons.push_back(logRefusal(refusals.size() - 1));
        return new IncludeResult("", reasons.back().data(), reasons.back().size(), nullptr);
    }

    void releaseInclude(IncludeResult* result) override { delete result; }

    std::vector<std::string> refusals;

private:
    // At once: the compilation may be ended, and what is to be watched for its mend is known.
    void tellFiles() {
        for (; told < search.files().size(); ++told) {
            Writer writer(Message::File);
            writer.string(search.files()[told].path.native());
            writer.string(search.files()[told].fingerprint);
            tell(writer.text);
        }
    }

    IncludeSearch& search;
    const Tell& tell;
    std::size_t told;
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

// In the child.
void compileWithGlslang(EShLanguage stage, const ShaderRequest& request, IncludeSearch& search,
                        const Tell& tell) {
    const std::string preamble = preambleOf(request.defines);
    const Source& entry = search.sources().front();
    const std::string name = logName(0);
    const std::array texts{entry.text.c_str()};
    const std::array lengths{static_cast<int>(entry.text.size())};
    const std::array names{name.c_str()};

    glslang::TShader shader(stage);  // must outlive the program
    shader.setStringsWithLengthsAndNames(texts.data(), lengths.data(), names.data(), 1);
    shader.setPreamble(preamble.c_str());
    setUp(shader, stage);
    Includer includer(search, tell);
    const bool parsed =
        shader.parse(GetDefaultResources(), versionWithoutDirective, false, messages, includer);
    std::string log = shader.getInfoLog();
    glslang::TProgram program;
    program.addShader(&shader);
    const bool linked = parsed && program.link(messages) && program.mapIO();
    if (linked) {
        std::vector<std::uint32_t> words;
        glslang::GlslangToSpv(*program.getIntermediate(stage), words);
        Writer writer(Message::Words);
        writer.bytes(words.data(), words.size() * sizeof words[0]);
        tell(writer.text);
        return;
    }
    if (parsed) {
        log += program.getInfoLog();
    }
    std::vector<CompileError> errors = readLog(log, search, includer.refusals);
    if (errors.empty()) {
        errors.push_back({entry.name, 0, "glslang refuses this shader and gives no reason"});
    }
    for (const CompileError& error : errors) {
        tellError(tell, error);
    }
}

// One, but with the sanitizer: its allocator, unlike glibc's, may be in use by another thread while this one
// forks, and then hangs in the child. That is taken for slowness, and tried once more.
std::vector<ChildLimits> attempts(const ChildLimits& limits) {
#ifdef __SANITIZE_ADDRESS__
    constexpr std::chrono::milliseconds moreThanUsual{3000};
    return {{limits.memoryBytes, std::min(limits.time, moreThanUsual)}, limits};
#else
    return {limits};
#endif
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
    static Tables tables;
    const auto lock = tables.of(*stage, search.sources().front());
    const auto work = [&](const Tell& tell) { compileWithGlslang(*stage, request, search, tell); };
    std::string reason;
    for (const ChildLimits& limits : attempts(request.limits)) {
        result = CompiledShader();
        result.files = search.files();
        reason = runInChild(
            work, [&result](std::string_view message) { hear(message, result); }, limits);
        if (!reason.starts_with("takes longer")) {
            break;
        }
    }
    if (!reason.empty()) {
        result.ended = true;
        result.words.clear();
        result.errors.push_back({name, 0, "the compilation " + reason});
    }
}

}  // namespace

CompiledShader compileShader(const ShaderRequest& request) {
#ifdef __SANITIZE_ADDRESS__
    // As told at attempts().
    static std::mutex oneAtATime;
    const std::scoped_lock lock(oneAtATime);
#endif
    CompiledShader result;
    IncludeSearch search(request.entry, request.roots);
    result.files = search.files();
    compile(request, search, result);
    return result;
}

std::string describe(const CompileError& error) {
    return error.line > 0 ? fmt::format("{}:{}: {}", error.file, error.line, error.text)
                          : fmt::format("{}: {}", error.file, error.text);
}

}  // namespace raytorus::compile
