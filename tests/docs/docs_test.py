"""The pages, README.md and docs/, against what they speak of: docs_test.py ROOT BUILD HONEYCOMB [unittest's arguments]."""
import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import markdown
import scenes

ROOT, BUILD, HONEYCOMB = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
PAGES = markdown.pages(ROOT)
# Blocks in these run (cpp: extract_code.py); those without a language are pictures in letters. Others say why not.
RUN, SHOWN = {"sh", "cpp", "python"}, {"", "text"}
# The options of other programs that pages name by themselves.
ELSEWHERE = {"--gtest_filter"}
FOLDERS = {path.name for path in ROOT.iterdir() if path.is_dir()} - {"build", "out"}
# What pages list value by value, as --help does.
LISTED = [("refine", "--scheme"), ("refine", "--backend"), ("refine", "--boundary"), ("convert", "--to"),
          ("bench", "--evaluators"), ("bench", "--layouts")]


def help_of(*command):
    done = subprocess.run([*map(str, command), "--help"], capture_output=True, text=True, check=True)
    return done.stdout


def options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][\w-]*", text))


class Links(unittest.TestCase):
    def test_lead_somewhere(self):
        for page in PAGES:
            for line, target in page.links():
                if re.match(r"https?://", target):
                    continue
                name, _, anchor = target.partition("#")
                goal = (page.path.parent / name).resolve() if name else page.path
                self.assertTrue(goal.exists(), f"{page.name}:{line}: there is no {target}")
                if anchor:
                    self.assertIn(anchor, markdown.Page(goal, ROOT).anchors(),
                                  f"{page.name}:{line}: {goal.name} has no such heading")

    def test_every_page_is_reached_from_the_readme(self):
        reached, waiting = set(), [ROOT / "README.md"]
        while waiting:
            page = waiting.pop()
            if page in reached or page.suffix != ".md":
                continue
            reached.add(page)
            waiting += [(page.parent / target.partition("#")[0]).resolve() for _, target in markdown.Page(page, ROOT).links()
                        if not target.startswith(("http", "#"))]
        self.assertEqual(set(), {page.path for page in PAGES} - reached, "no page links to these")

    def test_files_that_are_named_exist(self):
        for page in PAGES:
            for line, text in page.spans():
                if text.split("/")[0] in FOLDERS and re.fullmatch(r"[\w./{},*-]+", text) and "NAME" not in text:
                    for path in expand(text):
                        self.assertTrue(list(ROOT.glob(path.rstrip("/"))), f"{page.name}:{line}: there is no {path}")


def expand(text):
    """a.{h,cpp} as a.h and a.cpp."""
    group = re.search(r"\{([^{}]*)\}", text)
    if not group:
        return [text]
    return [whole for part in group.group(1).split(",")
            for whole in expand(text[:group.start()] + part + text[group.end():])]


class Options(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.help = {}
        cls.collect()
        cls.help |= {script: help_of(sys.executable, ROOT / script) for script in ("bench/report.py", "bench/counts")}

    @classmethod
    def collect(cls, *commands):
        """The help of a command and of those within it."""
        text = help_of(HONEYCOMB, *commands)
        cls.help[" ".join(["honeycomb", *commands])] = text
        for command in re.findall(r"^  (\w+) ", text.partition("Subcommands:")[2], re.MULTILINE):
            cls.collect(*commands, command)

    def command_of(self, words):
        """What has a --help of its own in a command line; nothing of other programs."""
        named = re.search(r"(?:^|\s)(?:\$bin|honeycomb)((?: \w+)*)(?![\w/_:-])|\b(bench/report\.py|bench/counts)\b", words)
        if not named or named.group(2):
            return named and named.group(2)
        command = "honeycomb"
        for word in named.group(1).split():
            if f"{command} {word}" not in self.help:
                break
            command += " " + word
        return command

    def check(self, place, words):
        command = self.command_of(words)
        if command:
            self.assertLessEqual(options_in(words), options_in(self.help[command]) | {"--help"},
                                 f"{place}: {command} hasn't these options")

    def test_of_commands_are_theirs(self):
        for page in PAGES:
            for block in (block for block in page.blocks if block.language == "sh"):
                for offset, line in enumerate(block.code.splitlines()):
                    for words in re.split(r"[;|&]", line.partition(" #")[0]):
                        self.check(f"{page.name}:{block.line + offset}", words)
            for line, text in page.spans():
                self.check(f"{page.name}:{line}", text)

    def test_named_alone_are_somebodys(self):
        known = set().union(*(options_in(text) for text in self.help.values())) | ELSEWHERE
        for page in PAGES:
            for line, text in page.spans():
                if text.startswith("--"):
                    self.assertLessEqual(options_in(text), known, f"{page.name}:{line}: no command has these options")

    def test_all_commands_and_values_are_on_a_page(self):
        spans = " ".join(text for page in PAGES for _, text in page.spans())
        code = " ".join(block.code for page in PAGES for block in page.blocks)
        for command in (command.removeprefix("honeycomb") for command in self.help if command.startswith("honeycomb ")):
            self.assertRegex(spans + code, rf"(\$bin|honeycomb){command}\b", f"no page shows honeycomb{command}")
        for command, option in LISTED:
            listed = re.search(rf"{option} .*?: ([\w-]+(?:, [\w-]+)+)", self.help[f"honeycomb {command}"])
            self.assertTrue(listed, f"the help of {command} {option} lists no values")
            for value in listed.group(1).split(", "):
                self.assertRegex(spans, rf"(?<![\w-]){value}(?![\w-])", f"no page names {value} of {command} {option}")

    def test_schemes_of_the_readme_are_those_of_the_help(self):
        table = (ROOT / "README.md").read_text(encoding="utf-8").partition("## Schemes")[2].partition("\n## ")[0]
        rows = [re.findall(r"`([\w-]+)`", row.split("|")[1]) for row in table.splitlines() if row.startswith("| `")]
        listed = re.search(r"--scheme .*?: ([\w-]+(?:, [\w-]+)+)", self.help["honeycomb refine"])
        self.assertEqual(listed.group(1).split(", "), sum(rows[1:], []), "the table of schemes")


class Blocks(unittest.TestCase):
    def test_run_or_say_why_not(self):
        lines = collections.Counter()
        for page in PAGES:
            for block in page.blocks:
                self.assertTrue(block.language in RUN | SHOWN or block.rule == "not run",
                                f"{block.place}: nothing runs blocks of {block.language}; say why not above it")
                self.assertTrue(block.rule == "" or block.detail, f"{block.place}: the rule above the block says nothing")
                lines[block.language, block.rule == "not run"] += len(block.code.splitlines())
        self.assertGreater(lines["sh", False], lines["sh", True], "more commands are left out than run")
        self.assertGreater(lines["cpp", False], 0, "no C++ is compiled")
        self.assertGreater(lines["python", False], 0, "no Python runs")

    def test_commands_run(self):
        self.run_language("sh", self.run_commands)

    def test_python_runs(self):
        self.run_language("python", self.run_python)

    def run_language(self, language, run):
        """A page's blocks, one after another in one process, in a folder that looks like a built repository with the
        reader's own files in it."""
        for page in PAGES:
            blocks = [block for block in page.blocks if block.language == language and block.rule != "not run"]
            if blocks:
                with self.subTest(page.name), tempfile.TemporaryDirectory() as folder:
                    self.fill(pathlib.Path(folder))
                    run(blocks, pathlib.Path(folder))

    def fill(self, folder):
        for name in ("assets", "bench"):
            (folder / name).symlink_to(ROOT / name)
        (folder / "build").mkdir()
        (folder / "build/release").symlink_to(BUILD)
        for name in ("creature.obj", "creature.pc2"):
            (folder / name).symlink_to(ROOT / "assets" / name)
        scenes.write_soldier(folder / "soldier.gltf")
        scenes.write_cloth(folder)

    def run_python(self, blocks, folder):
        """By the interpreter that runs this, for which the module is built."""
        script = "known = {}\n"
        for block in blocks:
            # Errors name the page and the line.
            code = "\n" * (block.line - 1) + block.runnable()
            script += f"exec(compile({code!r}, {block.page!r}, 'exec'), known)\n"
        done = subprocess.run([sys.executable, "-B", "-c", script], cwd=folder, capture_output=True, text=True, check=False,
                              env={**os.environ, "PYTHONPATH": str(BUILD / "python")}, timeout=200)
        self.assertEqual(0, done.returncode, done.stderr[-2000:])

    def run_commands(self, blocks, folder):
        """`honeycomb` is on the path."""
        script = "set -euo pipefail; trap 'echo \"$block: failed: $BASH_COMMAND\" >&2' ERR\n"
        script += "bin=build/release/apps/cli/honeycomb\n"
        script += "".join(f"block={block.place}\n{block.runnable()}\n" for block in blocks)
        script += "echo all of it"
        environment = {**os.environ, "PATH": f"{HONEYCOMB.parent}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1",
                       "XDG_CACHE_HOME": str(folder / "cache"), "OMPI_MCA_rmaps_base_oversubscribe": "1",
                       "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        done = subprocess.run(["timeout", "200", "bash", "-c", script], cwd=folder, env=environment, capture_output=True, text=True,
                              check=False, stdin=subprocess.DEVNULL)
        self.assertEqual(0, done.returncode, done.stderr[-2000:])
        self.assertTrue(done.stdout.endswith("all of it\n"), "a block ended the shell")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
