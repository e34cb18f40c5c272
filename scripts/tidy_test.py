#!/usr/bin/env python3
"""tidy.py must see what it claims to see: each case is a small tree with one mistake, or none."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

TIDY = pathlib.Path(__file__).with_name("tidy.py")


def tidy(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        done = subprocess.run(
            [sys.executable, TIDY, folder], capture_output=True, text=True, check=False
        )
        return done.returncode, done.stdout


class TidyTest(unittest.TestCase):
    def assert_found(self, files, expected):
        code, out = tidy(files)
        self.assertEqual(code, 1, out)
        self.assertIn(expected, out)
        self.assertEqual(out.count("\n"), 1, out)

    def test_clean_tree(self):
        code, out = tidy({"protocol/a.h": '#pragma once\n#include "common/b.h"\n'})
        self.assertEqual((code, out), (0, ""))

    def test_layers(self):
        self.assert_found({"protocol/a.cpp": '#include "client/x.h"\n'}, "protocol may not include")
        self.assert_found({"server/a.cpp": '#include "client/x.h"\n'}, "server may not include")
        self.assert_found(
            {"client/face/a.cpp": '#include "client/playback/x.h"\n'}, "client/face may not include"
        )

    def test_own_header_first(self):
        self.assert_found(
            {"server/a.h": "#pragma once\n", "server/a.cpp": '#include <x>\n#include "server/a.h"\n'},
            "server/a.cpp:1: its own header",
        )

    def test_pure_folders(self):
        for line in ("auto t = Clock::now();", 'std::printf("x");', "spdlog::info(1);"):
            self.assert_found({"protocol/a.cpp": line + "\n"}, "pure folder")
        self.assert_found({"protocol/a.cpp": "#include <asio.hpp>\n"}, "pure folder")
        code, out = tidy({"server/a.cpp": "auto t = Clock::now();\n"})
        self.assertEqual((code, out), (0, ""))

    def test_lengths(self):
        self.assert_found({"server/a.cpp": "x" * 101 + "\n"}, "101 columns")
        self.assert_found({"server/a.cpp": "int f() {\n" + "  x();\n" * 71 + "}\n"}, "71 lines")
        self.assert_found({"server/a.cpp": "\n" * 601}, "601 lines")

    def test_leftovers(self):
        self.assert_found({"server/a.cpp": "// TO" "DO later\n"}, "a leftover")
        self.assert_found({"server/a.cpp": "#if 0\n"}, "a leftover")
        self.assert_found({"server/a.cpp": "  // f(x);\n"}, "commented-out")

    def test_headers(self):
        self.assert_found({"server/a.h": "int x;\n"}, "#pragma once")
        self.assert_found(
            {"server/a.h": "#pragma once\nusing namespace std;\n"}, "using namespace"
        )


if __name__ == "__main__":
    unittest.main()
