#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What scripts/dist writes, without running it on a device: python3 tests/ports/write_test.py <folder of dist>."""
from __future__ import annotations

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
root = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "scripts"))
from ports import glsl, single_glsl, source, splice, wgsl  # noqa: E402
import kernels  # noqa: E402
from prove import SEALED  # noqa: E402

dist = Path(sys.argv.pop(1)) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else root / "dist"
# Names that people give to macros before they include a library, each an expression, which breaks whoever has the name.
MACROS = ("R C T r u p s a b c d f g h i k m n o q w v size scale unit ring tube distance step steps clear line point end from middle "
          "left right lower upper outer inner next error hits ray torus count known found value slope root bend ends base "
          "foot shift move sum rest low high zero x y z direction origin tMin tMax axis normal radius").split()
VERSIONS = ("330", "400", "410", "420", "430", "440", "450", "460", "300 es", "310 es", "320 es")
TIERS = ("", "#define TORUS_FAST\n", "#define TORUS_NO_PRECISE\n")


def dist_text(name: str) -> str:
    return (dist / name).read_text()


def compile_glsl(code: str, stage: str = "frag", *options: str) -> tuple[str, bytes]:
    """What glslangValidator says of a shader, and its SPIR-V if it was asked for."""
    with tempfile.TemporaryDirectory() as folder:
        shader = Path(folder) / f"shader.{stage}"
        shader.write_text(code)
        module = Path(folder) / "shader.spv"
        done = subprocess.run(["glslangValidator", "--quiet", *(f"{o}" for o in options), *(["-o", module] if "-V" in options else []),
                               shader], capture_output=True, text=True, check=False)
        return done.stdout.replace(str(shader), "shader").strip(), module.read_bytes() if module.exists() else b""


def lines_without_first(text: str) -> str:
    return "\n".join(text.split("\n")[1:])


class Written(unittest.TestCase):
    def test_every_version_of_glsl_takes_both_files_in_every_tier(self):
        for name in ("raytorus.glsl", "raytorus.min.glsl"):
            for version in VERSIONS:
                for tier in TIERS:
                    with self.subTest(name=name, version=version, tier=tier):
                        said, _ = compile_glsl(f"#version {version}\n{tier}{dist_text(name)}{kernels.GLSL_FRAGMENT}")
                        self.assertRegex(said, r"^(shader)?$")

    def test_every_version_of_glsl_takes_the_pasted_function(self):
        use = """out vec4 color;
void main() {
    float t;
    vec3 p;
    vec3 n;
    color = raytorusFast(1.0, 0.25, vec3(gl_FragCoord.xy, 3.0), 0.0, vec3(0.0, 0.0, -1.0), 9.0, t, p, n) ? vec4(n, t) : vec4(p, t);
}
"""
        for version in VERSIONS:
            precision = "precision highp float;\n" if version.endswith("es") else ""
            with self.subTest(version=version):
                said, _ = compile_glsl(f"#version {version}\n{precision}{dist_text('raytorus_fast.glsl')}{use}")
                self.assertRegex(said, r"^(shader)?$")

    def test_included_twice_it_is_there_once(self):
        text = dist_text("raytorus.min.glsl")
        said, _ = compile_glsl(f"#version 450\n{text}{text}{kernels.GLSL_FRAGMENT.replace('uniform vec2', 'layout(location = 0) uniform vec2')}")
        self.assertRegex(said, r"^(shader)?$")

    def test_no_macro_of_a_user_touches_the_stripped_file(self):
        defines = "".join(f"#define {name} (iResolution.xy)\n" for name in MACROS)
        undefines = "".join(f"#undef {name}\n" for name in MACROS)
        with_macros = f"#version 450\n{defines}{dist_text('raytorus.min.glsl')}{undefines}{kernels.GLSL_TRACE}"
        said, module = compile_glsl(with_macros, "comp", "-V")
        self.assertRegex(said, r"^(shader)?$")
        _, plain = compile_glsl(f"#version 450\n{dist_text('raytorus.min.glsl')}{kernels.GLSL_TRACE}", "comp", "-V")
        self.assertTrue(module)
        self.assertEqual(module, plain)

    def test_the_stripped_file_has_no_comment_but_the_licence(self):
        text = dist_text("raytorus.min.glsl")
        self.assertTrue(text.startswith("// SPDX-License-Identifier: MIT\n"))
        self.assertNotIn("//", lines_without_first(text))
        self.assertLess(len(text), 0.6 * len(dist_text("raytorus.glsl")))

    def test_the_public_names_are_the_same_in_every_language(self):
        declared = re.compile(r"\b(torus[A-Z]\w*)\s*\(")
        library = set(declared.findall(re.sub(r"//[^\n]*", "", (root / "shaders/torus/torus.glsl").read_text())))
        self.assertIn("torusIntersect", library)
        for file in sorted(dist.glob("raytorus*")):
            if file.name in ("raytorus_fast.glsl", "raytorus_unity.hlsl"):
                continue  # one function, with a name of its own
            with self.subTest(file=file.name):
                self.assertLessEqual(library, set(declared.findall(file.read_text())))

    def test_no_name_of_wgsl_ends_in_a_digit(self):
        for name in ("raytorus.wgsl", "raytorus_fast.wgsl", "raytorus_naga_oil.wgsl"):
            code = re.sub(r"(//|#)[^\n]*", "", dist_text(name))
            names = set(re.findall(r"\b[A-Za-z_]\w*", code)) - {"f32", "i32", "u32", "vec2", "vec3"}
            self.assertEqual([], sorted(n for n in names if n[-1].isdigit()))

    def test_no_float_of_wgsl_is_hexadecimal(self):
        for name in ("raytorus.wgsl", "raytorus_fast.wgsl"):
            with self.subTest(name=name):
                self.assertEqual([], re.findall(r"0x[0-9a-f]*[.p].*", dist_text(name)))

    def test_cxx_compiles_without_a_warning(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "raytorus.hpp").write_text(dist_text("raytorus.hpp"))
            (Path(folder) / "port.cpp").write_text(kernels.CXX_PROGRAM)
            for standard in ("c++11", "c++20"):
                for tier in ([], ["-DTORUS_FAST"]):
                    command = ["c++", f"-std={standard}", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror",
                               *tier, "-c", "port.cpp", "-o", "port.o"]
                    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
                    self.assertEqual((0, ""), (done.returncode, done.stderr))

    def test_the_self_check_sees_what_fast_math_breaks(self):
        program = """#include <cstdlib>
#include "raytorus.hpp"
int main(int, char** argv) { return raytorus_cxx::torusSelfCheck(std::strtof(argv[1], nullptr)); }
"""
        exact = 1 | 2 | 4  # TORUS_CHECK_SUMS, _PRODUCTS and _HIGHP
        sealed = dist_text("raytorus.hpp")
        broken, count = SEALED.subn("(x)", sealed)
        self.assertEqual(1, count)
        for header, options, expected in ((sealed, ["-O2"], exact), (sealed, ["-O3", "-ffast-math"], exact), (broken, ["-O2"], exact),
                                          (broken, ["-O3", "-ffast-math"], exact - 1)):
            with tempfile.TemporaryDirectory() as folder, self.subTest(options=options, broken=header is broken):
                (Path(folder) / "raytorus.hpp").write_text(header)
                (Path(folder) / "check.cpp").write_text(program)
                subprocess.run(["c++", *options, "check.cpp", "-o", "check"], cwd=folder, check=True)
                found = subprocess.run([Path(folder) / "check", "1"], check=False).returncode
                self.assertEqual(expected, found & exact)

    def test_written_twice_it_is_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([root / "scripts/dist", "--output", folder], check=True, capture_output=True)
            for file in sorted(dist.glob("raytorus*")):
                self.assertEqual(file.read_text(), (Path(folder) / file.name).read_text(), file.name)


class Seals(unittest.TestCase):
    """Each operation that rounds is sealed, whatever is written around it."""

    def sealed(self, body: str) -> str:
        text = f"float torus_f(float a, float b, vec3 v) {{\n    return {body};\n}}\n"
        tree = glsl.parse(text)
        splice.Types(tree)
        seals = single_glsl.Seals(splice.sealing_functions(tree), "R", "RR", "uint zero", "uint zero = torus_zero({});")
        return re.search(r"return (.*);", splice.Splice(text, seals.rules()).write(tree))[1]

    def test_sums_products_and_quotients(self):
        self.assertEqual("R(R(a + b) - R(a * b))", self.sealed("(a + b) - a * b"))
        self.assertEqual("R(R(a / b) + R(b / a))", self.sealed("a / b + b / a"))

    def test_a_second_division_by_the_same_number(self):
        self.assertEqual("R(R(a / b) + R(v.x / R(b)))", self.sealed("a / b + v.x / b"))

    def test_powers_of_two_round_nothing(self):
        self.assertEqual("R(2.0 * a + 0.5 * b)", self.sealed("2.0 * a + 0.5 * b"))
        self.assertEqual("R(R(3.0 * a) + b)", self.sealed("3.0 * a + b"))

    def test_what_does_not_round_is_left(self):
        self.assertEqual("-a", self.sealed("-a"))
        self.assertEqual("a < b ? max(a, b) : sqrt(a)", self.sealed("a < b ? max(a, b) : sqrt(a)"))

    def test_the_zero_is_handed_down(self):
        text = "float torus_g(float a) {\n    return a + 1.0;\n}\nfloat torusF(vec3 v) {\n    return torus_g(v.x);\n}\n"
        tree = glsl.parse(text)
        splice.Types(tree)
        seals = single_glsl.Seals(splice.sealing_functions(tree), "R", "RR", "uint zero", "uint zero = torus_zero({});")
        written = splice.Splice(text, seals.rules()).write(tree)
        self.assertIn("float torus_g(float a, uint zero)", written)
        self.assertIn("uint zero = torus_zero(v, v);", written)
        self.assertIn("torus_g(v.x, zero)", written)


class Parsing(unittest.TestCase):
    def test_what_is_no_glsl_of_ours_is_named_with_its_line(self):
        for text, said in (("float f() {\n    return 1.0\n}\n", "line 3: ; expected"),
                           ("float f() { return @; }", "line 1: no GLSL"),
                           ("struct S { float a b; };", "line 1: ; expected")):
            with self.assertRaisesRegex(glsl.GlslError, re.escape(said)):
                glsl.parse(text)

    def test_conditions_are_decided(self):
        text = "#if defined(A) && __VERSION__ < 330\none\n#elif B > 2\ntwo\n#else\nthree\n#endif\n"
        self.assertEqual("one\n", source.decide(text, {"A": "", "__VERSION__": "300"}))
        self.assertEqual("two\n", source.decide(text, {"B": "3"}))
        self.assertEqual("three\n", source.decide(text, {"A": ""} | {"__VERSION__": "450"}))

    def test_a_wrong_folder_is_a_sentence(self):
        done = subprocess.run([root / "scripts/dist", "--library", "/no/such/folder", "--output", "/tmp"], capture_output=True,
                              text=True, check=False)
        self.assertEqual((4, "scripts/dist: /no/such/folder/torus.glsl: No such file or directory\n"),
                         (done.returncode, done.stderr))

    def test_wgsl_parenthesizes_what_glsl_does_not(self):
        tree = glsl.parse("bool torus_f(bool a, bool b, bool c) {\n    return a && b || c;\n}\n")
        types = splice.Types(tree)
        text = "bool torus_f(bool a, bool b, bool c) {\n    return a && b || c;\n}\n"
        self.assertIn("(a && b) || c", splice.Splice(text, wgsl.Wgsl(tree, types).rules()).write(tree))


if __name__ == "__main__":
    unittest.main()
