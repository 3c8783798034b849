"""bench/report.py on what `honeycomb bench` writes: report_test.py HONEYCOMB REPORT."""
import html.parser
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

HONEYCOMB, REPORT = sys.argv[1:3]
SVG = "{http://www.w3.org/2000/svg}"


class Balance(html.parser.HTMLParser):
    """Every element that is opened is closed, in order; nothing is loaded from elsewhere."""

    def __init__(self):
        super().__init__()
        self.open, self.loaded = [], []

    def handle_starttag(self, tag, attrs):
        self.loaded += [value for name, value in attrs if name in ("src", "href")]
        if tag != "meta":
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        pass

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag


class ReportTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def bench(self, faces):
        file = self.path / f"{faces}.json"
        subprocess.run([HONEYCOMB, "bench", "--faces", str(faces), "--levels", "1,2", "--samples", "1", "--sample-ms", "0",
                        "--evaluators", "serial,csr,opensubdiv-cpu", "--json", str(file)], check=True, capture_output=True)
        return file

    def report(self, *files):
        command = [sys.executable, REPORT, *map(str, files), "--out", str(self.path / "report.html"), "--svg",
                   str(self.path / "svg")]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def test_two_sizes_make_one_page_with_charts_and_tables(self):
        files = [self.bench(64), self.bench(16)]
        self.assertEqual(self.report(*files).returncode, 0)
        page = (self.path / "report.html").read_text(encoding="utf-8")
        balance = Balance()
        balance.feed(page)
        self.assertEqual((balance.open, balance.loaded), ([], []))
        for words in ("Scaling with the mesh", "Scaling with the level", "Against the memory", "faster than serial", "csr",
                      "honeycomb tables"):
            self.assertIn(words, page)

    def test_scaling_chart_has_a_mark_for_each_evaluator_and_size(self):
        files = [self.bench(64), self.bench(16)]
        self.report(*files)
        measured = {run["evaluator"] for run in json.loads(files[0].read_text())["runs"]}
        chart = xml.etree.ElementTree.parse(self.path / "svg/akleman-torus-level-2-xyzw-by-control-faces.svg").getroot()
        marks = [title.text for title in chart.iter(f"{SVG}title") if " at " in title.text]
        self.assertEqual(len(marks), 2 * len(measured))
        for evaluator in measured:
            self.assertEqual(sum(mark.startswith(f"{evaluator}: ") for mark in marks), 2, evaluator)
        width, height = float(chart.get("width")), float(chart.get("height"))
        for text in chart.iter(f"{SVG}text"):
            self.assertTrue(0 <= float(text.get("x")) <= width and 0 <= float(text.get("y")) <= height, text.text)

    def test_what_is_no_benchmark_is_refused_in_one_line(self):
        wrong = self.path / "wrong.json"
        for content in ("{", "[]", '{"runs": [{}]}', '{"machine": {}, "limits": {"measured": []}, "runs": [], "skipped": [], '
                        '"build": []}'):
            wrong.write_text(content)
            done = self.report(wrong)
            self.assertEqual(done.returncode, 1, content)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertFalse((self.path / "report.html").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
