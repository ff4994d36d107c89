"""blysk replicate, from outside: what its documents hold, and what it refuses."""

import json
import math
import os
import re
import signal
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from command import BLYSK, REPOSITORY, CommandTest, read_png

VERDICTS = {"holds", "holds in part", "does not hold"}


class Replicate(CommandTest):
    def replicate(self, *arguments, **options):
        return self.run_command("replicate", "--study", "shading", "--quick", *arguments, **options)

    def test_json(self):
        output, errors = self.replicate("--json")
        self.assertEqual(errors, "")
        data = json.loads(output)
        self.assertEqual(set(data), {"version", "date", "machine", "studies"})
        (study,) = data["studies"]
        self.assertEqual(study["study"], "shading")
        tables = {t["id"]: t for section in study["sections"] for t in section["tables"]}
        for name in ("2.1", "4.2", "4.3", "4.4", "4.5", "programs", "speed", "gain", "speed-scalar", "lobe-speed", "errors",
                     "lobes"):
            table = tables[name]
            self.assertTrue(table["rows"], name)
            for row in table["rows"]:
                self.assertEqual(len(row), len(table["columns"]), (name, row))
        clocks = {row[0]: row[-1] for row in tables["4.4"]["rows"]}
        self.assertEqual(clocks["what the printed clocks are made of"], 146036)
        self.assertEqual(clocks["true sum"], 146936)
        for row in tables["speed"]["rows"]:
            self.assertTrue(all(cycles > 0 for cycles in row[1:]), row)

        claims = {c["id"]: c for c in study["claims"]}
        self.assertEqual(len(claims), len(study["claims"]))
        for claim in claims.values():
            self.assertIn(claim["verdict"], VERDICTS)
            self.assertTrue(claim["why"] and claim["source"] and claim["measured"], claim["id"])
            for measured in claim["measured"]:
                self.assertTrue(math.isfinite(measured["value"]), claim["id"])
        # These do not depend on the machine.
        self.assertEqual(claims["taylor-root"]["verdict"], "holds")
        self.assertEqual(claims["chebyshev-root"]["verdict"], "holds in part")
        self.assertEqual(claims["third-intensity"]["verdict"], "does not hold")
        self.assertAlmostEqual(claims["formula-2.3"]["modelled"], 3)

    def test_markdown_and_plots(self):
        os.mkdir(self.path("plots"))
        output, errors = self.replicate("shape:torus", "--markdown", "-o", "plots")
        self.assertEqual(errors, "")
        page = output.decode()
        self.assertTrue(page.startswith("# Replication\n"))
        self.assertRegex(page, r"\| method \|.*\| torus \|.*\| frame gain, torus \|")
        self.assertRegex(page, r"\ntimes of|; times of \d{4}-\d\d-\d\d, ")
        columns = None
        for line in page.splitlines():
            if not line.startswith("|"):
                columns = None
                continue
            count = len(re.findall(r"(?<!\\)\|", line))
            columns = columns or count
            self.assertEqual(count, columns, line)
        links = re.findall(r"!\[[^]]+\]\(([^)]+)\)", page)
        self.assertEqual(len(links), 2)
        for link in links:
            root = xml.etree.ElementTree.fromstring(self.read(link))
            self.assertGreater(len(root.findall("{http://www.w3.org/2000/svg}circle")), 5)

    def test_text(self):
        output, errors = self.replicate()
        self.assertEqual(errors, "")
        self.assertRegex(output.decode(), r"(?m)^\d+ claims: \d+ holds?, \d+ holds? in part, \d+ do(es)? not hold$")

    def test_abuffer(self):
        os.mkdir(self.path("plots"))
        words = ("replicate", "--study", "abuffer", "--scenes", "mesh-2k")
        page = self.run_command(*words, "--markdown", "-o", "plots")[0].decode()
        plots = re.findall(r"!\[[^]]+\]\((plots/[^)]+)\)", page)
        self.assertEqual([os.path.splitext(plot)[1] for plot in plots], [".png", ".svg"])
        self.assertEqual(read_png(self.read(plots[0])).width, 128)
        self.assertEqual(len(xml.etree.ElementTree.fromstring(self.read(plots[1])).findall("{http://www.w3.org/2000/svg}polyline")), 7)
        (study,) = json.loads(self.run_command(*words, "--json", "--threads=1")[0])["studies"]
        for section in study["sections"]:
            for table in section["tables"]:
                for row in table["rows"]:
                    self.assertEqual(len(row), len(table["columns"]), table["title"])
        self.assertTrue(study["claims"])
        self.assertLessEqual({claim["verdict"] for claim in study["claims"]}, VERDICTS)
        self.fails(2, "replicate", "--study", "abuffer", "--scenes", "soup-7")
        self.fails(3, *words, "missing.obj")

    def test_tells_a_terminal_what_goes_on_until_it_is_interrupted(self):
        terminal, theirs = os.openpty()
        process = self.start("replicate", "-o", ".", stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        shown = b""
        while shown.count(b" ...") < 3:  # not before a second has gone
            shown += os.read(terminal, 1000)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=10), 130)
        try:
            while more := os.read(terminal, 1000):
                shown += more
        except OSError:  # how a terminal's end reads
            pass
        os.close(terminal)
        self.assertRegex(shown, rb"^\r\x1b\[K[-|/\\\\] [a-z][^\r]* \.\.\.\r\x1b\[K")
        self.assertTrue(shown.endswith(b"\r\x1b[K"), shown[-80:])
        self.assertEqual(os.listdir(self.folder), ["square.obj"])

    def test_refusals(self):
        self.assertIn("--json", self.fails(2, "replicate", "--json", "--markdown"))
        self.assertIn("--study", self.fails(2, "replicate", "--study", "nothing"))
        self.assertIn("abuffer", self.fails(2, "replicate", "--scenes", "grass"))
        self.assertIn("missing.obj", self.fails(3, "replicate", "--study", "shading", "--quick", "missing.obj"))
        self.assertIn("create it", self.fails(4, "replicate", "--quick", "-o", "nowhere"))

    def test_every_shading_method_has_its_page(self):
        methods = json.loads(self.run_command("methods", "--json")[0])["methods"]
        for name in (m["name"] for m in methods if m["kind"] == "shading"):
            for page in (f"texts/{name}.md", f"{name}.md"):
                path = os.path.join(REPOSITORY, "docs", "methods", page)
                self.assertTrue(os.path.exists(path), f"{page} is missing: write texts/{name}.md, run tools/method-pages")
        tool = os.path.join(REPOSITORY, "tools", "method-pages")
        done = subprocess.run([sys.executable, "-B", tool, "--check", BLYSK], stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
