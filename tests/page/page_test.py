"""The pages and plots that Blysk writes, laid out by a real browser: nothing is cut off or overlaps, and every picture
shows."""

import glob
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BLYSK = os.environ.get("BLYSK", "blysk")
REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--hide-scrollbars",
         "--disable-background-networking", "--disable-component-update", "--disable-sync", "--virtual-time-budget=5000"]

# Told in the page itself: the browser prints the document after scripts have run.
MEASURE = """
<script>
addEventListener("load", () => {
  const box = e => { const r = e.getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]; };
  const all = (what, tell) => [...document.querySelectorAll(what)].map(tell);
  const told = document.createElement("pre");
  told.id = "told";
  told.textContent = JSON.stringify({
    width: document.documentElement.scrollWidth,
    images: all("img", i => ({natural: [i.naturalWidth, i.naturalHeight], box: box(i)})),
    rows: all(".row", r => [...r.querySelectorAll("img")].map(i => i.clientWidth / i.naturalWidth)),
    links: all("a", a => a.getAttribute("href") && document.querySelector(a.getAttribute("href")) !== null),
    first_cells: all("td:first-child", box), tables: all(".scroll", box),
    svg: all("svg", box), texts: all("svg text", t => ({text: t.textContent, box: box(t)})),
    circles: all("svg circle", box)});
  document.body.append(told);
});
</script>
"""


@unittest.skipIf(BROWSER is None, "there is no chromium: tools/install-packages page")
class PageTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def laid_out(self, page, width):
        with open(self.path("measured.html"), "w", encoding="utf-8") as file:
            file.write(page.replace("</body>", MEASURE + "</body>"))
        done = subprocess.run([BROWSER, *FLAGS, "--user-data-dir=" + self.path("profile"), f"--window-size={width},900",
                               "--dump-dom", "file://" + self.path("measured.html")],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120, check=True)
        told = re.search(r'<pre id="told">(.*?)</pre>', done.stdout.decode(), re.DOTALL)
        self.assertIsNotNone(told, done.stderr.decode())
        return json.loads(told[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))

    def report(self):
        page = self.path("report.html")
        subprocess.run([BLYSK, "compare", "--quiet", "shape:sphere?detail=8", "--methods", "all", "--size", "320x240",
                        "--report", page], check=True, stdout=subprocess.DEVNULL)
        with open(page, encoding="utf-8") as file:
            return file.read()

    def test_report_on_a_desk(self):
        told = self.laid_out(self.report(), 1400)
        self.assertLessEqual(told["width"], 1400)
        self.assertGreater(len(told["images"]), 30)
        for image in told["images"]:
            self.assertGreater(min(image["natural"]), 0)
        for row in told["rows"]:  # one scale, or pictures cannot be compared
            self.assertEqual(len(row), 3)
            self.assertLess(max(row) / min(row), 1.03, row)
        self.assertEqual(len(told["links"]), len(told["rows"]))
        self.assertTrue(all(told["links"]))

    def test_report_on_a_telephone(self):
        told = self.laid_out(self.report(), 500)
        self.assertLessEqual(told["width"], 500)  # the table scrolls, not the page
        for image in told["images"]:
            self.assertLessEqual(image["box"][2], 500)
            self.assertGreater(image["box"][2] - image["box"][0], 300)
        (table,) = told["tables"]
        for cell in told["first_cells"]:
            self.assertGreaterEqual(cell[0], table[0])

    def test_plots(self):
        subprocess.run([BLYSK, "replicate", "--quiet", "--quick", "--study", "shading", "-o", self.folder], check=True,
                       stdout=subprocess.DEVNULL)
        plots = glob.glob(self.path("*.svg"))
        self.assertEqual(len(plots), 2)
        for plot in plots:
            with open(plot, encoding="utf-8") as file:
                told = self.laid_out(f"<!DOCTYPE html><body style='width: 900px; margin: 0'>{file.read()}</body>", 1000)
            (frame,) = told["svg"]
            for text in told["texts"]:
                left, top, right, bottom = text["box"]
                self.assertTrue(left >= frame[0] and top >= frame[1] and right <= frame[2] and bottom <= frame[3],
                                (plot, text))
                for circle in told["circles"]:
                    x, y = (circle[0] + circle[2]) / 2, (circle[1] + circle[3]) / 2
                    self.assertFalse(left < x < right and top + 2 < y < bottom - 2, (plot, text, circle))
            for i, one in enumerate(told["texts"]):
                for other in told["texts"][:i]:
                    a, b = one["box"], other["box"]
                    overlap = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
                    self.assertFalse(overlap[0] > 1 and overlap[1] > 4, (plot, one, other))


if __name__ == "__main__":
    if BROWSER is None:
        print("skipped: there is no chromium (tools/install-packages page)")
        sys.exit(77)
    unittest.main()
