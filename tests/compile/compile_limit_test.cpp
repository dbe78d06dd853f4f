// SPDX-License-Identifier: MIT
// Shaders that are written to exhaust the compiler: each is refused in bounded memory and time, as any shader
// that does not compile, and what it was made of is known for all that.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "compile/compile_shader.hpp"
#include "compile/file_watch.hpp"
#include "shader_folder.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::compile {
namespace {

using namespace std::chrono_literals;
using test::errorsOf;
using test::filesOf;
using test::ShaderFolder;

// M0 is x; each next one is twice the one before, with a sign between: 2^count words.
std::string doublingMacros(int count, const char* between) {
    std::string text = "#define M0 x\n";
    for (int i = 1; i <= count; ++i) {
        const std::string one = "M" + std::to_string(i - 1);
        text += "#define M" + std::to_string(i) + " " + one + " " + between + " " + one + "\n";
    }
    return text;
}

// S0 is a float; each next one has two of the one before.
std::string doublingStructures(int count) {
    std::string text = "struct S0 { float a; };\n";
    for (int i = 1; i <= count; ++i) {
        const std::string one = "S" + std::to_string(i - 1);
        text += "struct S" + std::to_string(i) + " { " + one + " a; " + one + " b; };\n";
    }
    return text;
}

long peakOfChildren() {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    return used.ru_maxrss;
}

class CompileLimits : public testing::Test {
protected:
    // It is refused for its memory or its time, as its limits say.
    CompiledShader refused(const std::string& entry, ChildLimits limits = {}) const {
        ShaderRequest request = folder.request(entry);
        request.limits = limits;
        const auto began = std::chrono::steady_clock::now();
        const CompiledShader shader = compileShader(request);
        EXPECT_LT(std::chrono::steady_clock::now() - began, 2 * limits.time + 5s);
        EXPECT_TRUE(shader.ended);
        EXPECT_TRUE(shader.words.empty());
        EXPECT_EQ(shader.errors.size(), 1U) << errorsOf(shader);
        EXPECT_TRUE(errorsOf(shader).starts_with(entry + ": the compilation takes ")) << errorsOf(shader);
        return shader;
    }

    ShaderFolder folder;
};

TEST_F(CompileLimits, MacrosThatDouble) {
    folder.writeShader("few.comp", doublingMacros(10, "+") + "void main() { x = M10; }\n");
    EXPECT_TRUE(folder.compile("few.comp").ok()) << errorsOf(folder.compile("few.comp"));
    folder.writeShader("e.comp", doublingMacros(37, "+") + "void main() { x = M37; }\n");
    // The compiler would take 24 GB, and the machine with them.
    refused("e.comp");
    EXPECT_LT(peakOfChildren(), (ChildLimits().memoryBytes >> 10U) * 3 / 2);
    // Without an end, and without memory.
    folder.writeShader("if.comp", doublingMacros(37, "||") + "#if M37\n#endif\nvoid main() {}\n");
    refused("if.comp", {.time = 1s});
}

TEST_F(CompileLimits, StructuresThatDouble) {
    folder.writeShader("few.comp",
                       doublingStructures(8) + "void main() { S8 s; x = s.a.a.a.a.a.a.a.a.a; }\n");
    EXPECT_TRUE(folder.compile("few.comp").ok()) << errorsOf(folder.compile("few.comp"));
    folder.writeShader("e.comp", doublingStructures(40) +
                                     "layout(set = 0, binding = 1, std430) buffer All { S40 s; };\n"
                                     "void main() { x = 1.0; }\n");
    refused("e.comp", {.time = 1s});
}

TEST_F(CompileLimits, TheMendIsSeen) {
    folder.write("include/macros.glsl", doublingMacros(37, "+"));
    folder.writeShader("e.comp", "#include \"include/macros.glsl\"\nvoid main() { x = M37; }\n");
    const CompiledShader shader = refused("e.comp", {.memoryBytes = 64 << 20});
    EXPECT_EQ(errorsOf(shader), "e.comp: the compilation takes more than 64 MiB of memory\n");
    EXPECT_EQ(filesOf(shader, folder.path), std::vector<std::string>({"e.comp", "include/macros.glsl"}));
    FileWatch watch(0ms);
    watch.watch(shader.files);
    EXPECT_TRUE(watch.poll().empty());
    folder.write("include/macros.glsl", "#define M37 1.0\n");
    EXPECT_EQ(watch.poll(), std::vector{folder.path / "include/macros.glsl"});
    EXPECT_TRUE(folder.compile("e.comp").ok());
}

TEST_F(CompileLimits, ManyAtOnce) {
    folder.writeShader("good.comp", "void main() { x = 1.0; }\n");
    folder.writeShader("bad.comp", "void main() { x = y; }\n");
    folder.writeShader("long.comp", doublingMacros(37, "||") + "#if M37\n#endif\nvoid main() {}\n");
    const CompiledShader good = folder.compile("good.comp");
    ASSERT_TRUE(good.ok() && !good.ended);
    std::atomic<int> right = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 6; ++i) {
        threads.emplace_back([&, i] {
            for (int k = 0; k < 20; ++k) {
                if (i % 2 == 0) {
                    right += folder.compile("good.comp").words == good.words ? 1 : 0;
                } else {
                    right +=
                        errorsOf(folder.compile("bad.comp")) == "bad.comp:5: 'y' : undeclared identifier\n"
                            ? 1
                            : 0;
                }
            }
        });
    }
    refused("long.comp", {.time = 300ms});
    std::ranges::for_each(threads, [](std::thread& thread) { thread.join(); });
    EXPECT_EQ(right, 6 * 20);
}

}  // namespace
}  // namespace raytorus::compile
