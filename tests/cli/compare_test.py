"""blysk compare, from outside: verdicts, statuses, error maps, and the report."""

import base64
import html.parser
import json
import os
import re
import struct
import unittest
import zlib

from command import CommandTest, picture_hash, read_png


def ppm(width, height, pixels):
    return b"P6\n%d %d\n255\n" % (width, height) + bytes(pixels)


def png(width, height, rgba):
    rows = b"".join(b"\0" + bytes(rgba[i:i + 4 * width]) for i in range(0, 4 * width * height, 4 * width))
    chunks = ((b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)), (b"IDAT", zlib.compress(rows)),
              (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body)) for kind, body in chunks)


class CompareTest(CommandTest):
    def setUp(self):
        super().setUp()
        gray = [100] * (16 * 12 * 3)
        self.write("gray.ppm", ppm(16, 12, gray))
        self.write("far.ppm", ppm(16, 12, [200] * len(gray)))
        gray[3 * (16 * 6 + 8)] = 103
        self.write("near.ppm", ppm(16, 12, gray))

    def compare(self, *arguments, status=0):
        return self.run_command("compare", *arguments, status=status)

    def document(self, *arguments, status=0):
        return json.loads(self.compare(*arguments, "--json", status=status)[0])


class Pictures(CompareTest):
    def test_equal_is_0_and_different_is_1(self):
        output, errors = self.compare("gray.ppm", "gray.ppm")
        self.assertEqual(errors, "")
        self.assertRegex(output.decode(), r"(?m)^gray\.ppm +equal +0 +look the same +inf dB +1\.00000 +0 +0 \(0\.00 %\)$")
        output, errors = self.compare("gray.ppm", "near.ppm", status=1)
        self.assertEqual(errors, "")
        self.assertRegex(output.decode(), r"(?m)^near\.ppm +different +\S+ +look the same +\S+ dB +0\.9\d+ +3 +1 \(0\.52 %\)$")

    def test_a_png_equals_its_ppm(self):
        for name in ("a.png", "a.ppm", "small.png"):
            self.render("square.obj", "--background=#204060", name=name)
        self.compare("a.png", "a.ppm", "small.png")

    def test_rendering_is_repeatable(self):
        self.render("shape:teapot", "--threads=1", "--isa=scalar", name="a.png")
        self.render("shape:teapot", "--threads=3", name="b.png")
        self.compare("a.png", "b.png")

    def test_bounds(self):
        self.compare("gray.ppm", "near.ppm", "--max-difference=2", status=1)
        self.compare("gray.ppm", "near.ppm", "--max-difference=3")
        self.compare("gray.ppm", "near.ppm", "--max-nmse=0.0001")
        self.compare("gray.ppm", "far.ppm", "--max-nmse=0.5", status=1)
        self.compare("gray.ppm", "far.ppm", "--max-nmse=1")
        self.compare("gray.ppm", "far.ppm", "--max-nmse=1", "--max-difference=99", status=1)
        self.compare("gray.ppm", "gray.ppm", "--max-nmse=0", "--max-difference=0")

    def test_alpha_alone_is_a_difference(self):
        self.write("a.png", png(2, 1, [1, 2, 3, 255] * 2))
        self.write("b.png", png(2, 1, [1, 2, 3, 255, 1, 2, 3, 250]))
        candidate = self.document("a.png", "b.png", status=1)["candidates"][0]
        self.assertEqual((candidate["nmse"], candidate["max_difference"], candidate["different_pixels"]), (0, 5, 1))
        self.assertIsNone(candidate["ssim"])

    def test_several_candidates(self):
        data = self.document("gray.ppm", "gray.ppm", "near.ppm", "far.ppm", status=1)
        self.assertFalse(data["equal"])
        self.assertEqual([c["equal"] for c in data["candidates"]], [True, False, False])
        self.assertEqual([c["max_difference"] for c in data["candidates"]], [0, 3, 100])
        self.assertEqual(data["candidates"][2]["nmse"], 1)
        self.assertEqual(data["candidates"][2]["class"], "completely different")
        self.assertAlmostEqual(data["candidates"][2]["psnr_db"], 8.1308, 4)
        self.assertIsNone(data["candidates"][0]["psnr_db"])
        self.assertEqual(data["candidates"][0]["sha256"], data["reference"]["sha256"])
        self.assertEqual(data["reference"]["name"], "gray.ppm")

    def test_hash_is_that_of_render(self):
        told = json.loads(self.run_command("render", "square.obj", "-q", "--json", "-o", "a.png", "--size=20x10")[0])
        self.assertEqual(self.document("a.png", "a.png")["reference"]["sha256"], told["sha256"])
        self.assertEqual(picture_hash(read_png(self.read("a.png"))), told["sha256"])

    def test_other_sizes_are_different(self):
        self.write("wide.ppm", ppm(17, 12, [100] * (17 * 12 * 3)))
        output, errors = self.compare("gray.ppm", "wide.ppm", "--max-nmse=1000", status=1)
        self.assertEqual((output, errors), (b"", "wide.ppm: 17x12 pixels, but the reference gray.ppm has 16x12\n"))
        data = self.document("gray.ppm", "wide.ppm", "gray.ppm", status=1)
        self.assertEqual([c["equal"] for c in data["candidates"]], [False, True])
        self.assertIsNone(data["candidates"][0]["nmse"])

    def test_unreadable(self):
        self.assertIn("missing.png", self.fails(3, "compare", "gray.ppm", "missing.png"))
        self.assertIn("missing.png", self.fails(3, "compare", "missing.png", "gray.ppm"))
        self.assertIn("square.obj", self.fails(3, "compare", "gray.ppm", "square.obj"))
        self.assertIn("folder", self.fails(3, "compare", "gray.ppm", "."))
        whole = self.render("square.obj")
        self.write("cut.png", whole[:-20])
        self.assertIn("cut.png", self.fails(3, "compare", "out.png", "cut.png"))
        self.write("bomb.png", png(1, 1, [0] * 4)[:16] + struct.pack(">II", 60000, 60000))
        self.fails(3, "compare", "gray.ppm", "bomb.png")
        self.fails(5, "compare", "gray.ppm", "gray.ppm", "--max-memory=700")

    def test_wrong_usage(self):
        for words in (["gray.ppm"], ["gray.ppm", "gray.ppm", "--view=front"], ["gray.ppm", "near.ppm", "--repeat=3"],
                      ["gray.ppm", "near.ppm", "--difference=map.jpg"], ["gray.ppm", "near.ppm", "--difference=-"],
                      ["gray.ppm", "near.ppm", "--reference=flat"], ["-", "-"], ["square.obj", "--methods=phong"],
                      ["square.obj", "--methods=none"], ["gray.ppm", "near.ppm", "--max-difference=256"],
                      ["square.obj", "--methods=all", "--shading=flat"]):
            self.fails(2, "compare", *words)
        self.fails(4, "compare", "gray.ppm", "near.ppm", "--difference=nowhere/map.png")
        self.fails(4, "compare", "gray.ppm", "near.ppm", "--report=nowhere/page.html")

    def test_standard_input_and_quiet(self):
        output, errors = self.run_command("compare", "gray.ppm", "-", "--quiet", status=1, input=self.read("near.ppm"))
        self.assertEqual((output, errors), (b"", ""))

    def test_difference_picture(self):
        self.compare("gray.ppm", "near.ppm", "--difference=map.png", status=1)
        picture = read_png(self.read("map.png"))
        self.assertEqual(picture.channels, 3)
        self.assertGreater(picture.width, 16)
        row = picture.bytes[3 * 6 * picture.width:][:3 * 16]
        self.assertEqual([row[i:i + 3] != bytes(3) for i in range(0, 48, 3)], [i == 8 for i in range(16)])
        data = self.document("gray.ppm", "near.ppm", "far.ppm", "--difference=several.png", status=1)
        self.assertEqual([c["difference"] for c in data["candidates"]], ["several.1.png", "several.2.png"])
        for candidate in data["candidates"]:
            self.assertEqual(read_png(self.read(candidate["difference"])).width, picture.width)
        self.assertFalse(os.path.exists(self.path("several.png")))


class Page(html.parser.HTMLParser):
    """What a page shows, and whatever it would fetch."""

    def __init__(self, text):
        super().__init__()
        self.pictures, self.open, self.text, self.names = [], [], "", []
        self.ids, self.targets = set(), set()
        self.feed(text)
        assert not self.open, self.open
        assert self.targets <= self.ids, self.targets

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.names.append(tag)
        self.ids.add(values.get("id"))
        if values.get("href", "").startswith("#"):
            self.targets.add(values.pop("href")[1:])
        for name in ("src", "href", "data", "action"):
            assert values.get(name, "data:").startswith("data:"), values
        if tag == "img":
            kind, _, data = values["src"].partition(",")
            assert kind == "data:image/png;base64"
            picture = read_png(base64.b64decode(data, validate=True))
            assert (picture.width, picture.height) == (int(values["width"]), int(values["height"]))
            assert values["alt"]
            self.pictures.append(picture)
        if tag not in ("img", "meta"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text += data


class Methods(CompareTest):
    WORDS = ("shape:sphere?detail=8", "--methods=all", "--size=64x48")

    def test_table_and_times(self):
        output, _ = self.compare(*self.WORDS, "--repeat=2")
        lines = output.decode().splitlines()
        self.assertRegex(lines[1], r"^phong +reference .* \d+\.\d\d ms +1\.00x$")
        self.assertRegex(output.decode(), r"(?m)^gouraud +different .* \d+\.\d\d ms +\d+\.\d\dx$")
        self.assertRegex(output.decode(), r"(?m)^flat +different .* dB ")

    def test_document(self):
        data = self.document(*self.WORDS)
        rows = json.loads(self.run_command("methods", "--json")[0])["methods"]
        shading = [row["name"] for row in rows if row["kind"] == "shading"]
        self.assertEqual([data["reference"]["name"], *(c["name"] for c in data["candidates"])], shading)
        self.assertFalse(data["equal"])
        for candidate in data["candidates"]:
            self.assertGreater(candidate["ms"], 0)
            self.assertGreater(candidate["speed_up"], 0)
        told = json.loads(self.run_command("render", "shape:sphere?detail=8", "-q", "--json", "-o", "a.png",
                                           "--size=64x48", "--shading=flat")[0])
        flat = next(c for c in data["candidates"] if c["name"] == "flat")
        self.assertEqual(flat["sha256"], told["sha256"])

    def test_scene_options_hold(self):
        camera = ("--view=top", "--light=0,1,0", "--color=1,0,0", "--transfer=none", "--lighting=lambert",
                  "--interpolation=screen", "--background=0,0,0", "--orthographic", "--cull=back")
        data = self.document(*self.WORDS, *camera)
        told = json.loads(self.run_command("render", "shape:sphere?detail=8", "-q", "--json", "-o", "a.png",
                                           "--size=64x48", *camera)[0])
        self.assertEqual(data["reference"]["sha256"], told["sha256"])

    def test_reference_and_bounds(self):
        data = self.document("square.obj", "--methods=phong,flat", "--reference=flat", "--size=32x24")
        self.assertEqual((data["reference"]["name"], [c["name"] for c in data["candidates"]]), ("flat", ["phong"]))
        self.compare(*self.WORDS, "--max-difference=0", status=1)
        self.compare(*self.WORDS, "--max-difference=255", "--max-nmse=1000")

    def test_difference_pictures_are_named_after_methods(self):
        self.compare("square.obj", "--methods=flat,gouraud", "--size=32x24", "--difference=map.png")
        self.assertTrue(os.path.exists(self.path("map.flat.png")))
        self.assertTrue(os.path.exists(self.path("map.gouraud.png")))

    def test_failures_are_those_of_render(self):
        self.assertIn("missing.obj", self.fails(3, "compare", "missing.obj", "--methods=all"))
        self.fails(5, "compare", "square.obj", "--methods=all", "--max-triangles=1")

    def test_report(self):
        self.compare(*self.WORDS, "--report=page.html")
        text = self.read("page.html").decode()
        page = Page(text)
        candidates = len(self.document(*self.WORDS)["candidates"])
        self.assertEqual(len(page.pictures), 3 * candidates)
        self.assertNotIn("script", page.names)
        self.assertNotRegex(text, r"https?:|url\(|@import|<link")
        for words in ("shape:sphere?detail=8", "gouraud", "SPEED-UP", "reference: phong", "64x48"):
            self.assertIn(words, page.text)
        hashes = {picture_hash(picture) for picture in page.pictures}
        told = self.document(*self.WORDS)
        for picture in (told["reference"], *told["candidates"]):
            self.assertIn(picture["sha256"], hashes)

    def test_report_of_pictures_with_evil_names(self):
        name = "<b>&\"'.ppm"
        self.write(name, self.read("near.ppm"))
        self.write("wide.ppm", ppm(17, 12, [100] * (17 * 12 * 3)))
        self.compare("gray.ppm", name, "wide.ppm", "--report=page.html", status=1)
        page = Page(self.read("page.html").decode())
        self.assertIn(name, page.text)
        self.assertNotIn("b", page.names)
        self.assertEqual(len(page.pictures), 5)
        self.assertEqual(len(re.findall("The sizes differ", page.text)), 1)


if __name__ == "__main__":
    unittest.main()
