#!/usr/bin/env python3
"""tidy.py must see what it claims to see: each case is a small tree with a fault, or none."""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import tidy

BODY = "  x();\n" * 71 + "}\n"


def findings(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return "".join(
            f"{path}:{number}: {text}\n" for path, number, text in tidy.findings(pathlib.Path(folder))
        )


class TidyTest(unittest.TestCase):
    def assert_found(self, files, expected):
        out = findings(files)
        self.assertIn(expected, out)
        self.assertEqual(out.count("\n"), 1, out)

    def assert_clean(self, files):
        self.assertEqual(findings(files), "")

    def test_clean_tree(self):
        self.assert_clean({"protocol/a.h": '#pragma once\n#include "common/b.h"\n'})

    def test_exit_code_and_form(self):
        with tempfile.TemporaryDirectory() as folder:
            for text, expected in (("int x;\n", (0, "")), ("#if 0\n", (1, "a.cpp:1: a leftover: #if 0\n"))):
                (pathlib.Path(folder) / "a.cpp").write_text(text, encoding="utf-8")
                done = subprocess.run(
                    [sys.executable, tidy.__file__, folder],
                    capture_output=True, text=True, check=False,
                )
                self.assertEqual((done.returncode, done.stdout), expected)

    def test_a_tree_without_sources_is_no_clean_tree(self):
        self.assert_found({"README.md": "text"}, "no source here")

    def test_every_folder_refuses_each_folder_that_it_may_not_include(self):
        for folder, allowed in tidy.MAY_INCLUDE.items():
            others = set(tidy.MAY_INCLUDE) - allowed - {folder}
            self.assertTrue(others, folder)
            text = "".join(f'#include "{other}/x.h"\n' for other in sorted(others))
            out = findings({f"{folder}/a.cpp": text})
            for other in others:
                self.assertIn(f"{folder} may not include {other}/x.h", out)
            self.assertEqual(out.count("\n"), len(others), out)
            self.assert_clean({
                f"{folder}/a.cpp":
                    "".join(f'#include "{other}/x.h"\n' for other in sorted(allowed | {folder}))
            })

    def test_folders_that_may_include_each_other_in_a_circle_are_refused(self):
        self.assertEqual(list(tidy.cycles(tidy.MAY_INCLUDE)), [])
        with unittest.mock.patch.dict(tidy.MAY_INCLUDE, {"common": {"server/serve"}}):
            self.assertIn("MAY_INCLUDE is a circle: common -> server/serve -> common",
                          findings({"a.cpp": ""}))
        self.assertEqual(list(tidy.cycles({"a": {"b"}, "b": {"c"}, "c": {"b"}})), [["b", "c", "b"]])

    def test_include_directions_that_matter_most(self):
        for folder, other in (
            ("common", "common/sources"), ("common", "common/tls"), ("common", "common/link"),
            ("common/sources", "common/tls"), ("protocol", "common/sources"),
            ("server/live", "server/serve"), ("server/live", "client/face"),
            ("client/face", "client/playback"), ("client/app/video", "client/app/window"),
            ("client/app/window", "server/live"),
        ):
            self.assertNotIn(other, tidy.MAY_INCLUDE[folder])

    def test_tests_include_what_they_test_and_what_that_may_include(self):
        for path, other, may in (
            ("tests/unit/link/a.cpp", "common/link/x.h", True), ("tests/unit/link/a.cpp", "common/tls/x.h", True),
            ("tests/unit/link/a.cpp", "tests/support/x.h", True), ("tests/unit/link/a.cpp", "tests/unit/web/x.h", True),
            ("tests/unit/link/a.cpp", "server/live/x.h", False), ("tests/unit/link/a.cpp", "tests/unit/face/x.h", False),
            ("tests/unit/page/a.cpp", "client/web/x.h", True), ("tests/unit/web/a.cpp", "client/web/x.h", False),
            ("tests/unit/protocol/a.cpp", "server/settings/x.h", True),
            ("tests/unit/protocol/a.cpp", "server/live/x.h", False), ("tests/unit/new/a.cpp", "common/x.h", False),
            ("tests/integration/a.cpp", "protocol/x.h", True), ("tests/integration/a.cpp", "server/x.h", False),
            ("tests/support/linkemu/a.cpp", "common/x.h", True), ("tests/support/a.h", "tests/unit/face/x.h", False),
            ("tests/fuzz/a.cpp", "protocol/x.h", True), ("tests/fuzz/a.cpp", "common/link/x.h", False),
            ("server/live/a.cpp", "tests/support/x.h", False), ("tests/unit/link/a.cpp", "elsewhere/x.h", False),
        ):
            files = {path: ("#pragma once\n" if path.endswith(".h") else "") + f'#include "{other}"\n'}
            if may:
                self.assert_clean(files)
            else:
                self.assert_found(files, f"may not include {other}")

    def test_every_folder_that_tests_may_include_more_than_theirs_is_known(self):
        root = pathlib.Path(tidy.__file__).parent.parent
        for folder, more in tidy.TESTS_MAY_INCLUDE.items():
            self.assertTrue((root / folder).is_dir(), folder)
            for other in more | {tidy.tested_by(folder)} - {""}:
                self.assertTrue((root / other).is_dir(), other)

    def test_shaders(self):
        def shader(line, name="a_fragment.glsl"):
            return {"a.cpp": "int x;\n", f"render/shaders/{name}": f"// smoothstep(1.0, 0.0, x)\n{line}\n"}

        for line in ("smoothstep(0.5, 0.1, x)", "smoothstep( 1 , -1, x)", "smoothstep(.5,\n  0.5, x)"):
            self.assert_found(shader(line), "render/shaders/a_fragment.glsl:2: smoothstep() is undefined")
        for line in ("smoothstep(-0.36, 0.0, x)", "smoothstep(cut, 0.1, x)", "/* smoothstep(1.0, 0.0, x) */",
                     "1.0 - smoothstep(0.0, 1.0, x)"):
            self.assert_clean(shader(line))

    def test_passes_of_one_picture_that_may_disagree_in_depth(self):
        text = "invariant gl_Position;  // why\nvoid main() { gl_Position = f(); }\n"
        both = {"a.cpp": "int x;\n", "render/shaders/depth_vertex.glsl": text, "render/shaders/lit_vertex.glsl": text}
        self.assert_clean(both)
        for name in ("depth", "lit"):
            place = f"render/shaders/{name}_vertex.glsl"
            for fault in (text.replace("invariant", "// invariant"), "void main() { gl_Position = f(); }\n"):
                self.assert_found(both | {place: fault}, f"{place}:1: does not declare `invariant gl_Position`")
            self.assert_found({path: text for path, text in both.items() if path != place}, f"{place}:1: does not")

    def test_a_folder_that_is_not_known_is_included_by_nobody(self):
        self.assert_found({"server/a.cpp": '#include "vendor/x.h"\n'}, "may not include vendor/x.h")

    def test_every_folder_with_sources_is_known(self):
        root = pathlib.Path(tidy.__file__).parent.parent
        for path in tidy.tracked_files(root):
            if path.startswith("tests/unit/"):
                self.assertTrue(tidy.tested_by(tidy.test_folder_of(path)), path)
            elif path.startswith("tests/"):
                self.assertIn(tidy.test_folder_of(path), tidy.TESTS_MAY_INCLUDE, path)
            elif not path.startswith("scripts/cmake/"):
                self.assertTrue(tidy.folder_of(path), path)

    def test_folders_that_are_new_are_walked(self):
        for path in ("a.cpp", "common/new/a.cpp", "tests/unit/a.cpp", "elsewhere/deep/a.cpp"):
            self.assert_found({path: "#if 0\n"}, f"{path}:1: a leftover")

    def test_reads_what_git_has_and_not_what_it_ignores(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            subprocess.run(["git", "init", "-q", folder], check=True)
            for name in ("a.cpp", "new.cpp", "ignored.cpp", "build/b.cpp", "deleted.cpp"):
                (root / name).parent.mkdir(exist_ok=True)
                (root / name).write_text("int x;\n", encoding="utf-8")
            (root / ".gitignore").write_text("ignored.cpp\nbuild\n", encoding="utf-8")
            subprocess.run(["git", "-C", folder, "add", "a.cpp", "deleted.cpp"], check=True)
            (root / "deleted.cpp").unlink()
            self.assertEqual(tidy.tracked_files(root), ["a.cpp", "new.cpp"])

    def test_own_header_first(self):
        self.assert_found(
            {"server/a.h": "#pragma once\n", "server/a.cpp": '#include <x>\n#include "server/a.h"\n'},
            "server/a.cpp:1: its own header",
        )

    def test_pure_folders(self):
        for folder in tidy.PURE:
            for line in ("auto t = Clock::now();", 'std::printf("x");', "spdlog::info(1);",
                         "std::cerr << 1;", "sleep_for(t);", '::setenv("a", "b", 1);'):
                self.assert_found({f"{folder}/a.cpp": line + "\n"}, "pure folder")
            for header in ("asio.hpp", "thread", "epoxy/gl.h", "GLFW/glfw3.h", "spdlog/spdlog.h",
                           "arpa/inet.h", "sys/socket.h", "unistd.h", "dlfcn.h"):
                self.assert_found({f"{folder}/a.cpp": f"#include <{header}>\n"}, "pure folder")
            self.assert_clean({f"{folder}/a.cpp": 'std::snprintf(a, 1, "x");  // not printf()\n'})
        self.assert_clean({"server/a.cpp": "auto t = Clock::now();\n"})
        self.assert_clean({"common/link/a.cpp": "#include <asio.hpp>\n"})

    def test_folders_that_know_no_file(self):
        for folder in tidy.KNOWS_NO_FILE:
            for header in ("<filesystem>", "<fstream>", '"common/files.h"', '"common/text_file.h"'):
                self.assert_found({f"{folder}/a.h": f"#pragma once\n#include {header}\n"}, "knows no file")
        self.assert_clean({"client/gui/storage/a.h": "#pragma once\n#include <filesystem>\n"})

    def test_what_single_files_of_pure_folders_touch_all_the_same(self):
        root = pathlib.Path(tidy.__file__).parent.parent
        for path in tidy.MAY_TOUCH:
            self.assertTrue((root / path).is_file(), path)
        self.assert_clean({"client/sound/openal_out.cpp": "#include <dlfcn.h>\n"})
        self.assert_found({"client/sound/openal_out.cpp": "#include <arpa/inet.h>\n"}, "pure folder")
        self.assert_found({"client/sound/openal_out.cpp": "auto t = Clock::now();\n"}, "pure folder")

    def test_lengths_of_lines_and_files(self):
        self.assert_found({"server/a.cpp": "x" * 101 + "\n"}, "101 columns")
        self.assert_clean({"server/a.cpp": "x" * 100 + "\n"})
        self.assert_found({"server/a.cpp": "\n" * 601}, "601 lines")
        self.assert_clean({"server/a.cpp": "\n" * 600})

    def test_every_form_of_a_long_function_is_found(self):
        for head in (
            "int f() {",
            "int f(const int& a,\n      int b) {",
            "int f(Options options = {},\n      int b) {",
            "int C::f() const noexcept {",
            "int C::f() const& {",
            "auto f() -> std::vector<int> {",
            "template <typename T>\nrequires std::integral<T>\nT f(T t) {",
            "C::C(int a) : a_(a), b_{1} {",
            "C::C(int a)\n    : a_(a),\n      b_{a, a},\n      c_{a,\n         a} {",
            "int f(\n    int a) try {",
            "TEST(Unit, States) {",
            "[[nodiscard]] int f() {  // why",
            "const auto f = [](int a) {",
        ):
            self.assert_found({"server/a.cpp": f"{head}\n{BODY}"}, "71 lines")
        member = "class C {\n public:\n  int f(int a,\n        int b) {\n" + "    x();\n" * 71
        self.assert_found({"server/a.cpp": member + "  }\n};\n"}, "71 lines")
        self.assert_clean({"server/a.cpp": "int f() {\n" + "  x();\n" * 70 + "}\n"})

    def test_nothing_hides_a_long_function_that_follows(self):
        for before in (
            "int g(int a,\n      int b) {\n  x();\n}\n",
            "C::C(int a)\n    : a_{a},\n      b_{a} {}\n",
            'const char* kText = R"(usage: {\nint g() {\n  )" "(";\n',
            "const char kBrace = '{';  // int g() {\n",
            "const Row kRows[] = {\n    {1, [](int a) {\n       return a;\n     }},\n    {2, f},\n};\n",
            "const std::map<int, int> kMap{\n    {1, 2},\n};\n",
            "#define X(a) \\\n  f(a)\n",
            "namespace {\n\nint x = f(1,\n          2);\n",
            "enum class E : int {\n  A,\n  B,\n};\n",
            "int g() {\n  if (a &&\n      b) {\n    x();\n  }\n  y([&] {\n    x();\n  });\n}\n",
        ):
            self.assert_found({"server/a.cpp": before + "\nint f() {\n" + BODY}, "71 lines")

    def test_what_is_long_and_no_function_is_left_alone(self):
        rows = "    {1, 2},\n" * 80
        self.assert_clean({"server/a.cpp": f"const Row kRows[] = {{\n{rows}}};\n"})
        self.assert_clean({"server/a.cpp": "namespace a {\n" + "int x;\n" * 80 + "}  // namespace a\n"})
        self.assert_clean({"server/a.cpp": "class C : public D<int()> {\n" + "  int x;\n" * 80 + "};\n"})

    def test_leftovers(self):
        self.assert_found({"server/a.cpp": "// TO" "DO later\n"}, "a leftover")
        self.assert_found({"server/a.cpp": "#if 0\n"}, "a leftover")
        self.assert_found({"server/a.cpp": "  // f(x);\n"}, "commented-out")

    def test_headers(self):
        self.assert_found({"server/a.h": "int x;\n"}, "#pragma once")
        self.assert_found(
            {"server/a.h": "#pragma once\nusing namespace std;\n"}, "using namespace"
        )

    def test_a_source_that_its_readme_does_not_name(self):
        header = {"server/live/a.h": "#pragma once\n", "server/live/a.cpp": '#include "server/live/a.h"\n'}
        project = header | {"README.md": "`a`", "tests/unit/b.cpp": "", "server/live/README.md": "| `a` | x |\n"}
        self.assert_clean(project)
        for text in ("a", "`b`, a, `ab`"):
            self.assert_found(project | {"server/live/README.md": text},
                              "server/live/a.cpp:1: server/live/README.md does not name `a`")
        for text in ("`live/a.h`", "```\nb -> a\n```\n"):
            self.assert_clean(project | {"server/live/README.md": text})
        below = {path: text for path, text in project.items() if path != "server/live/README.md"}
        self.assert_clean(below | {"server/README.md": "`live/a`"})
        self.assert_found(below, "server/live/a.cpp:1: no README.md of its folder")
        self.assert_clean(header)

    def test_a_readme_of_classes_that_names_no_thread(self):
        project = {"README.md": "x", "server/live/a.h": "#pragma once\nclass A {\n};\n"}
        for text, found in (("`a`", True), ("`a`: the loop's thread", False), ("`a`. Threads: one.", False)):
            tree = project | {"server/live/README.md": text}
            if found:
                self.assert_found(tree, "server/live/README.md:1: does not say on which thread the folder runs")
            else:
                self.assert_clean(tree)
        functions = {"server/live/a.h": "#pragma once\nclass B;\nint a(const B& b);\n", "server/live/README.md": "`a`"}
        self.assert_clean(project | functions)

    def test_a_readme_whose_lines_are_too_long(self):
        project = {"a/b.cpp": "", "a/README.md": "`b`\n"}
        for line, found in (("x" * 140, False), ("x" * 141, True), ("- " + "x" * 139, True),
                            ("| " + "x" * 139, False), ("[x](" + "y" * 139 + ")", False)):
            tree = project | {"README.md": "# x\n" + line + "\n"}
            if found:
                self.assert_found(tree, "README.md:2: 141 columns, at most 140")
            else:
                self.assert_clean(tree)

    def test_a_page_that_names_a_class_which_is_gone(self):
        project = {"a/b.cpp": "class NewName;", "a/README.md": "`b`, `x::NewName`\n", "README.md": "# x\n"}
        self.assert_clean(project)
        for text in ("OldName", "`PascalCase`", "```\nOldName\n```\n"):
            self.assert_clean(project | {"a/GUIDE.md": text})
        for page in ("README.md", "a/GUIDE.md"):
            self.assert_found(project | {page: "# x\n`b`, `y::OldName`\n"}, f"{page}:2: there is no `OldName`")
        self.assert_clean(project | {"CHANGELOG.md": "`OldName` is `NewName`"})

    def test_a_library_links_only_folders_that_its_own_may_include(self):
        def linked(by, library):
            lists = {f"server/{room}/CMakeLists.txt": f"aucast_library(x_{room} SOURCES a.cpp)\n"
                     for room in ("settings", "live")}
            lists[f"server/{by}/CMakeLists.txt"] = (
                f"# A room.\naucast_library(x_{by}\n  SOURCES a.cpp\n  LINK aucast_toml {library})\n")
            return lists | {"server/a.cpp": "int x;\n"}

        self.assert_clean(linked("serve", "x_live"))
        self.assert_found(linked("settings", "x_live"), "server/settings/CMakeLists.txt:2: server/settings may not "
                                                        "link x_live, which is of server/live")

    def test_names_that_collide_where_a_unity_build_joins_two_sources(self):
        def two(first, second, form="namespace {{\n\n{}\n\n}}  // namespace\n"):
            return {"server/live/a.cpp": form.format(first), "server/b.cpp": form.format(second),
                    "server/CMakeLists.txt": "aucast_library(x\n  live/a.cpp\n  b.cpp)\n"}

        for name, first, second in (
            ("kMax", "constexpr int kMax = 1;", "const char* const kMax = f(2);"),
            ("kBrow", 'constexpr Key kBrow("a");', "constexpr double kBrow[] = {1};"),
            ("Row", "struct Row {\n  int x;\n};", "class Row final : public A {\n};"),
            ("Kind", "enum class Kind : char { A };", "using Kind = B;"),
            ("id()", "int id() {\n  return 1;\n}", "std::string id() {\n  return {};\n}"),
            ("f(const int&, int)", "int f(const int& a, int b = 1) {\n}",
             "template <class T>\nint f(const int& x,\n      int y) {\n}"),
        ):
            self.assert_found(two(first, second), f"server/b.cpp:3: x has {name} already, in server/live/a.cpp")
            self.assert_clean(two(first, second, "namespace n {{\n{}\n}}  // namespace n\n"))
            both = two(first, second)
            both["server/CMakeLists.txt"] = "aucast_library(x live/a.cpp)\naucast_test(y b.cpp)\n"
            self.assert_clean(both)
        for first, second in (
            ("using Kind = A;", "using Kind = A;"), ("namespace fs = a;", "namespace fs = a;"),
            ("class Row;", "class Row;"), ("int f(int a) {\n}", "int f(char a) {\n}"),
            ("TEST(A, B) {\n}", "TEST(A, C) {\n}"), ("int f() {\n  int kMax = 1;\n}", "int g() {\n  int kMax = 1;\n}"),
        ):
            self.assert_clean(two(first, second))

    def test_texts_that_are_translated_but_never_said(self):
        def said(source, row="{place}: it is gone; call {whom}"):
            return {"client/gui/texts/english_errors.h": '#pragma once\n{"bad.gone",\n "' + row + '"},\n',
                    "client/gui/texts/english_tips.h": "#pragma once\n", "server/a.cpp": source}

        for source in ('f("it is gone; call ");\n', 'f("it is "\n  "gone; call " + name);\n',
                       'f("it is" + rest(" gone; call"));\n', 'f(R"(it is gone; call)");\n'):
            self.assert_clean(said(source))
        for source in ('f("it is away; call ");\n', '// "it is gone; call "\n', 'f("it is");\n'):
            self.assert_found(said(source), "client/gui/texts/english_errors.h:2: bad.gone: nothing says 'it is gone; call'")
        self.assert_clean(said("", "No such file or directory"))
        for spoken in (True, False):
            files = said('f("it is gone; call ");\n' + 'f("leave out --tls");\n' * spoken)
            files["client/gui/texts/said_text.cpp"] = 'x = {{"leave out "\n "--tls", "play.tls"}};\n'
            if spoken:
                self.assert_clean(files)
            else:
                self.assert_found(files, "client/gui/texts/said_text.cpp:1: play.tls: nothing says 'leave out --tls'")
        tip = said("") | {"client/gui/texts/english_tips.h": '#pragma once\n{"it is gone; call "},\n'}
        self.assert_found(tip, "nothing says 'it is gone; call'")


if __name__ == "__main__":
    unittest.main()
