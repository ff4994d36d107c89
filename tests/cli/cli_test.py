"""The command, from outside: what it prints, writes, refuses and leaves behind."""

import json
import os
import re
import shutil
import signal
import statistics
import struct
import subprocess
import time
import unittest

from command import BLYSK, REPOSITORY, SQUARE, CommandTest, picture_hash, read_netpbm, read_png

SUBCOMMANDS = ("render", "compare", "info", "methods", "replicate", "verify", "man", "completion")


def manual_rows():
    """Rows of the option tables: {option: (signature, default, example, subcommands)}."""
    page = subprocess.run([BLYSK, "man", "--markdown"], stdout=subprocess.PIPE, check=True).stdout.decode()
    rows = {}
    for line in page.split("\n## Options\n")[1].split("\n## ")[0].splitlines():
        cells = [cell.strip().strip("`") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) == 6 and "--" in cells[0] and not cells[0].startswith("---"):
            signature, _, _, default, example, users = (cell.replace("\\|", "|") for cell in cells)
            rows[re.search(r"--([a-z-]+)", signature)[1]] = (signature, default, example, users.split(", "))
    return rows


class Help(CommandTest):
    def test_general_help_lists_subcommands_and_statuses(self):
        output, errors = self.run_command("--help")
        for name in SUBCOMMANDS:
            self.assertRegex(output.decode(), rf"\n  {name} ")
        for status in (0, 1, 2, 3, 4, 5, 70):
            self.assertRegex(output.decode(), rf"\n  {status} ")
        self.assertEqual(errors, "")
        self.assertEqual(self.run_command("-h")[0], output)

    def test_each_subcommand_has_help_with_an_example(self):
        for name in SUBCOMMANDS:
            output = self.run_command(name, "--help")[0].decode()
            self.assertTrue(output.startswith(f"Usage: blysk {name} "))
            self.assertIn(f"\n  blysk {name}", output)
            self.assertLessEqual(max(map(len, output.splitlines())), 120)

    def test_help_prints_every_default(self):
        rows = manual_rows()
        self.assertGreater(len(rows), 30)
        helps = {name: " ".join(self.run_command(name, "--help")[0].decode().split()) for name in SUBCOMMANDS}
        for signature, default, _, users in rows.values():
            for user in SUBCOMMANDS if users == ["all"] else users:
                self.assertIn(signature, helps[user])
                if default:
                    self.assertIn(f"default: {default}", helps[user])

    def test_help_wins_over_missing_arguments(self):
        self.assertIn(b"Usage", self.run_command("render", "--size", "8x8", "-h")[0])

    def test_version_is_fast(self):
        times = []
        for _ in range(15):
            start = time.perf_counter()
            output, _ = self.run_command("--version")
            times.append((time.perf_counter() - start) * 1000)
        self.assertRegex(output.decode(), r"\Ablysk \d+\.\d+\.\d+\n\Z")
        print(f"\nblysk --version: median {statistics.median(times):.1f} ms, Python's start of it included")
        self.assertLess(statistics.median(times), 500 if os.environ.get("BLYSK_SANITIZE") else 50)

    def test_manual_is_clean_roff(self):
        page, _ = self.run_command("man")
        for part in (b".TH BLYSK 1", b".SH OPTIONS", b"\\-\\-shading", b".SH EXIT STATUS"):
            self.assertIn(part, page)
        if not shutil.which("groff"):
            self.skipTest("groff is not here to check it")
        done = subprocess.run(["groff", "-man", "-ww", "-Tutf8"], input=page, capture_output=True, check=True)
        self.assertEqual(done.stderr, b"")
        self.assertIn("--background COLOUR", re.sub("\x1b\\[[0-9;]*m|.\b", "", done.stdout.decode()))

    def test_documents_are_up_to_date(self):
        for subcommand, page in (("man", "command.md"), ("methods", "methods.md")):
            with open(os.path.join(REPOSITORY, "docs", page), "rb") as file:
                document = file.read()
            self.assertEqual(self.run_command(subcommand, "--markdown")[0].decode(), document.decode(),
                             f"run: blysk {subcommand} --markdown > docs/{page}")

    def test_every_example_of_an_option_works(self):
        beside = {"target": ["--eye", "1,2,3"], "up": ["--eye", "1,2,3"], "point-light": ["--ambient=0"],
                  "aov-format": ["--aov=depth"]}
        for name, (_, _, example, users) in manual_rows().items():
            if not example or "render" not in users:
                continue
            model = "shape:triangles?count=5" if name == "camera" else "square.obj"
            words = ["render", "-q", model, *beside.get(name, []), *example.split(" ")]
            words += [] if name == "size" else ["--size=16x16"]
            words += [] if name == "output" else ["-o", "out.png"]
            with self.subTest(name):
                self.run_command(*words)

    def test_every_example_of_a_subcommand_works(self):
        os.makedirs(self.path(".local/share/bash-completion/completions"))
        self.write("teapot.obj", SQUARE)
        self.write("part.stl", "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                   "vertex 0 1 0\nendloop\nendfacet\nendsolid part\n")
        self.write("model.glb", one_triangle_glb())
        for name in ("expected.png", "actual.png"):
            self.render("square.obj", name=name)
        environment = {**os.environ, "HOME": self.folder, "MANPAGER": "cat",
                       "PATH": os.path.dirname(os.path.abspath(BLYSK)) + ":" + os.environ["PATH"]}
        for name in SUBCOMMANDS:
            help_text = self.run_command(name, "--help")[0].decode()
            for line in re.findall(r"^  (blysk .*)$", help_text.split("\nExamples\n")[1], re.MULTILINE):
                if "man -l" in line and not shutil.which("man"):
                    continue
                if name == "replicate":  # takes minutes; replicate_test.py runs it small
                    continue
                with self.subTest(line):
                    done = subprocess.run(["bash", "-o", "pipefail", "-c", line], cwd=self.folder, env=environment,
                                          capture_output=True, timeout=60)
                    self.assertEqual(done.returncode, 0, done.stderr.decode())
        self.assertEqual(read_png(self.read("model.png")).width, 1280)


def one_triangle_glb():
    positions = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    document = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "buffers": [{"byteLength": 36}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]}]}).encode()
    document += b" " * (-len(document) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(document) + 36) +
            struct.pack("<I4s", len(document), b"JSON") + document + struct.pack("<I4s", 36, b"BIN\0") + positions)


class Usage(CommandTest):
    def refuses(self, expected, *arguments):
        message = self.fails(2, *arguments)
        self.assertIn(expected, message)
        self.assertEqual(os.listdir(self.folder), ["square.obj"])

    def test_nothing_asked(self):
        self.refuses("blysk --help")

    def test_suggestions(self):
        self.refuses("'render'", "redner", "square.obj")
        self.refuses("blysk render square.obj", "square.obj")
        self.refuses("--shading", "render", "square.obj", "-o", "a.png", "--shadding", "flat")
        self.refuses("'gouraud'", "render", "square.obj", "-o", "a.png", "--shading", "gourod")
        self.refuses("'depth'", "render", "square.obj", "-o", "a.png", "--aov", "normal,dpeth")
        self.refuses("blysk verify", "render", "square.obj", "-o", "a.png", "--print")
        self.refuses("teapot", "render", "shape:teapto", "-o", "a.png")
        self.refuses("bash", "completion", "bsah")
        self.refuses("'--help'", "help")
        self.refuses("'--version'", "version")

    def test_domains(self):
        for bad in ("--size=0x0", "--size=99999x1", "--size=10", "--size=10x10x10", "--size=1.5x2", "--size=axb",
                    "--size=-4x4", "--fov=0", "--fov=nan", "--fov=inf", "--fov=171", "--fov=45deg", "--fov=",
                    "--zoom=0", "--zoom=-1", "--eye=1,2", "--eye=1,2,3,4", "--eye=1,2,nan", "--eye=1;2;3",
                    "--eye=1e400,0,0", "--light=0,0,0", "--light=1,2,3,4", "--light=1,2,3,-1,0,0",
                    "--point-light=1,2", "--ambient=-0.1", "--color=1,1,1.1", "--color=red", "--specular=0,0",
                    "--shininess=0.5", "--shininess=1001", "--crease=-1", "--crease=181", "--background=1,1",
                    "--background=2,0,0", "--background=#12345", "--background=#gggggg", "--background=white",
                    "--threads=0", "--threads=1.5", "--threads=-1", "--threads=2000", "--repeat=0",
                    "--max-triangles=0", "--max-memory=12Q", "--max-memory=", "--orthographic=0",
                    "--orthographic=-2", "--transfer=gamma", "--cull=front", "--up-axis=x", "--format=jpg",
                    "--aov=depth,", "--antialias=", "--json=yes", "--isa=mmx", "--view=behind"):
            with self.subTest(bad):
                option = bad.split("=")[0]
                self.refuses(option, "render", "square.obj", "-o", "a.png", bad)

    def test_options_that_do_not_go_together(self):
        for bad in (["--eye", "1,2,3", "--view", "front"], ["--eye", "1,2,3", "--camera", "0"], ["--target", "0,0,0"],
                    ["--up", "0,0,1"], ["--camera", "0", "--zoom", "2"], ["--eye", "1,2,3", "--target", "1,2,3"],
                    ["--eye", "0,5,0", "--target", "0,0,0"], ["--camera", "0"], ["--orthographic", "2", "--zoom", "2"]):
            with self.subTest(bad):
                self.refuses("--", "render", "square.obj", "-o", "a.png", *bad)
        self.refuses("-o", "render", "square.obj")
        self.refuses("MODEL", "render", "-o", "a.png")
        self.refuses("--json", "render", "square.obj", "-o", "-", "--json")
        self.refuses("--aov", "render", "square.obj", "-o", "-", "--aov", "depth")
        self.refuses("--aov-format", "render", "square.obj", "-o", "a.png", "--aov-format", "csv")
        self.refuses("'csv'", "render", "square.obj", "-o", "a.png", "--aov", "depth", "--aov-format", "cvs")
        self.refuses("once", "render", "-", "-", "-o", "a.png")
        self.refuses("xyz", "render", "square.obj", "-o", "a.xyz")
        self.refuses("b.obj", "info", "square.obj", "b.obj")

    def test_value_missing(self):
        self.refuses("--size", "render", "square.obj", "-o", "a.png", "--size")

    def test_both_spellings_mean_the_same(self):
        first = self.render("square.obj", "--fov", "30", "--light", "-.5,1,2")
        self.assertEqual(first, self.render("--fov=30", "--light=-.5,1,2", "square.obj"))
        self.assertEqual(first, self.render("--fov=80", "--fov=30", "--light=-.5,1,2", "--", "square.obj"))

    def test_orthographic_height_is_optional(self):
        self.render("--orthographic", "square.obj")
        low, high = (self.render("square.obj", "--view=front", *words)
                     for words in (["--orthographic", "2.5"], ["--orthographic=25"]))
        self.assertNotEqual(low, high)


class Render(CommandTest):
    def test_png(self):
        opaque = read_png(self.render("square.obj", "--background", "1,0.2,0", size="40x30"))
        self.assertEqual(opaque[:3], (40, 30, 3))
        self.assertEqual(opaque.bytes[:3], bytes((255, 51, 0)))
        clear = read_png(self.render("square.obj", "--background", "transparent"))
        self.assertEqual((clear.channels, clear.bytes[:4]), (4, bytes(4)))
        hexadecimal = read_png(self.render("square.obj", "--background", "#10203040"))
        self.assertEqual(hexadecimal.bytes[:4], bytes((0x10, 0x20, 0x30, 0x40)))

    def test_the_model_is_in_the_picture(self):
        picture = read_png(self.render("square.obj", "--view=front", "--background=0,0,0"))
        middle = (picture.height // 2 * picture.width + picture.width // 2) * 3
        self.assertNotEqual(picture.bytes[middle:middle + 3], bytes(3))
        self.assertEqual(picture.bytes[:3], bytes(3))

    def test_formats_hold_the_same_pixels(self):
        png = read_png(self.render("square.obj"))
        magic, width, height, body = read_netpbm(self.render("square.obj", name="out.ppm"))
        self.assertEqual((magic, width, height, body), (b"P6", 32, 24, png.bytes))
        magic, width, height, body = read_netpbm(self.render("square.obj", name="out.pfm"))
        self.assertEqual((magic, width, height, len(body)), (b"PF", 32, 24, 32 * 24 * 12))
        self.assertEqual(self.render("square.obj", "--format=png", name="out.bin"), self.render("square.obj"))

    def test_standard_output_and_input(self):
        expected = self.render("square.obj")
        output, errors = self.run_command("render", "-", "-o", "-", "--format", "png", "--size", "32x24",
                                          input=SQUARE.encode())
        self.assertEqual(output, expected)
        self.assertIn("standard output: 32x24", errors)
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.png", "square.obj"])

    def test_json(self):
        output, errors = self.run_command("render", "square.obj", "-o", "out.png", "--size", "32x24", "--json", "-q",
                                          "--threads", "2", "--repeat", "3", "--aov", "depth,id")
        self.assertEqual(errors, "")
        data = json.loads(output)
        self.assertEqual(list(data), ["version", "input", "output", "size", "threads", "simd", "triangles", "pixels",
                                      "fragments", "memory", "ms", "sha256", "repeat", "aov"])
        self.assertEqual((data["input"], data["output"], data["size"]), (["square.obj"], "out.png", [32, 24]))
        self.assertEqual((data["threads"], data["repeat"]), (2, 3))
        self.assertEqual(sorted(data["triangles"]), ["culled", "drawn", "in"])
        self.assertEqual(data["triangles"]["in"], 2)
        self.assertGreater(data["pixels"]["covered"], 0)
        self.assertEqual(sorted(data["ms"]), ["frame", "geometry", "load", "tiles", "total", "write"])
        self.assertTrue(all(value >= 0 for value in data["ms"].values()))
        self.assertGreaterEqual(data["ms"]["total"], data["ms"]["load"])
        self.assertGreater(data["memory"]["peak"], 1 << 20)
        self.assertEqual(data["sha256"], picture_hash(read_png(self.read("out.png"))))
        self.assertEqual(data["aov"], {"depth": "out.depth.png", "id": "out.id.png"})

    def test_bytes_do_not_depend_on_threads_or_instruction_set(self):
        expected = self.render("shape:torus", size="100x70")
        for words in (["--threads=1"], ["--threads=3"], ["--isa=scalar"], ["--repeat=2"]):
            self.assertEqual(self.render("shape:torus", *words, size="100x70"), expected)

    def test_pictures_beside(self):
        self.render("square.obj", "--aov", "depth,normal,id", name="a.pfm")
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["a.depth.pfm", "a.id.pfm", "a.normal.pfm", "a.pfm", "square.obj"])
        depths = read_netpbm(self.read("a.depth.pfm"))
        self.assertEqual((depths[0], len(depths[3])), (b"Pf", 32 * 24 * 4))
        numbers = struct.unpack("<768f", depths[3])
        self.assertEqual(max(numbers), 1)
        self.assertLess(min(numbers), 1)
        ids = struct.unpack("<768f", read_netpbm(self.read("a.id.pfm"))[3])
        self.assertLessEqual(set(ids), {0, 1, 2})
        self.assertEqual(read_netpbm(self.read("a.normal.pfm"))[0], b"PF")
        self.render("square.obj", "--aov=id")
        self.assertEqual(read_png(self.read("out.id.png")).channels, 3)

    def test_a_plane_that_cannot_be_written_leaves_the_picture(self):
        self.write("a.png", b"old")
        os.mkdir(os.path.join(self.folder, "a.id.png"))
        before = sorted(os.listdir(self.folder))
        self.assertIn("a.id.png: this is a folder", self.fails(4, "render", "square.obj", "-o", "a.png", "--aov=depth,id"))
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        self.assertEqual(self.read("a.png"), b"old")

    def test_fragments_and_coverage_beside(self):
        self.render("square.obj", "--aov=fragments,coverage,fragments", "--aov-format=csv,png", "--antialias=none")
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["out.coverage.csv", "out.coverage.png", "out.fragments.csv", "out.fragments.png", "out.png",
                          "square.obj"])
        picture, gray = read_png(self.read("out.fragments.png")), read_png(self.read("out.coverage.png"))
        self.assertEqual((gray.width, gray.height), (32, 24))
        self.assertGreater(picture.width, 32)  # the key
        counts = [line.split(",") for line in self.read("out.fragments.csv").decode().splitlines()]
        self.assertEqual((len(counts), {len(row) for row in counts}), (24, {32}))
        self.assertEqual({word for row in counts for word in row}, {"0", "1"})
        self.assertEqual(self.read("out.coverage.csv"), self.read("out.fragments.csv"))
        for y in range(24):
            for x in range(32):
                shown = gray.bytes[gray.channels * (32 * y + x)]
                self.assertEqual(shown, 255 * int(counts[y][x]))
                first = picture.channels * (picture.width * y + x)
                self.assertEqual(any(picture.bytes[first:first + 3]), counts[y][x] == "1")

    def test_shares_of_samples_as_numbers(self):
        self.render("square.obj", "--aov=fragments,coverage,depth", "--aov-format=csv,pfm")
        coverage = [float(word) for word in self.read("out.coverage.csv").decode().replace("\n", ",").split(",")[:-1]]
        self.assertLessEqual({16 * share for share in coverage}, set(range(17)))
        self.assertGreater(len(set(coverage)), 3)
        # PFM begins with the lowest row.
        rows = [coverage[32 * y:32 * y + 32] for y in range(24)]
        floats = read_netpbm(self.read("out.coverage.pfm"))[3]
        self.assertEqual(struct.unpack("<768f", floats), tuple(share for row in reversed(rows) for share in row))
        counts = [int(word) for word in self.read("out.fragments.csv").decode().replace("\n", ",").split(",")[:-1]]
        self.assertEqual([n > 0 for n in counts], [share > 0 for share in coverage])
        self.assertEqual(max(counts), 2)  # along the diagonal
        depths = self.read("out.depth.csv").decode().replace("\n", ",").split(",")[:-1]
        self.assertEqual([depth == "1" for depth in depths], [n == 0 for n in counts])

    def test_statistics(self):
        words = ("render", "shape:cube", "-o", "out.png", "--size=40x30", "--cull=none", "--statistics")
        plain = self.render("shape:cube", "--cull=none", size="40x30")
        output, errors = self.run_command(*words, "--json", "--aov=fragments", "--aov-format=csv,png")
        self.assertEqual(self.read("out.png"), plain)
        data = json.loads(output)
        self.assertEqual(data["aov"], {"fragments": ["out.fragments.csv", "out.fragments.png"]})
        fragments = data["fragments"]
        counts = [int(word) for word in self.read("out.fragments.csv").decode().replace("\n", ",").split(",")[:-1]]
        self.assertEqual(fragments["live"]["total"], sum(counts))
        self.assertEqual(data["pixels"]["covered"], 1200 - counts.count(0))
        self.assertEqual(fragments["live"]["histogram"], [[n, counts.count(n)] for n in sorted(set(counts))])
        self.assertEqual(fragments["live"]["most"], max(counts))
        self.assertEqual(fragments["live"]["mean"], sum(counts) / 1200)
        self.assertEqual(fragments["live"]["p99"], sorted(counts)[1199 * 99 // 100])
        self.assertEqual(fragments["generated"]["total"] - fragments["hidden"], sum(counts))
        self.assertGreater(fragments["hidden"], 100)  # what faces away
        self.assertNotIn("most_live", fragments)
        self.assertNotIn("buffers", data["memory"])
        self.assertRegex(errors, r"fragments a pixel +mean +99 % +most +all\ngenerated +[\d.]+ .*\nlive at the end .*\n"
                                 r"[\d.]+ % hidden\n")
        self.assertEqual(self.run_command(*words, "-q"), (b"", ""))
        data = json.loads(self.run_command("render", "shape:cube", "-o", "out.png", "--size=40x30", "--json")[0])
        self.assertNotIn("generated", data["fragments"])

    def test_lists_tell_what_they_hold(self):
        words = ("render", "shape:cube", "-o", "out.png", "--size=128x64", "--antialias=abuffer-pool:pool=100")
        output, errors = self.run_command(*words, "--statistics", "--json", "-v")
        data = json.loads(output)
        fragments, buffers = data["fragments"], data["memory"]["buffers"]
        self.assertEqual(fragments["hidden"], fragments["hidden_on_arrival"] + fragments["removed_later"])
        self.assertEqual(fragments["most_live"]["most"], fragments["most_at_once"])
        self.assertGreaterEqual(fragments["most_live"]["total"], fragments["live"]["total"])
        self.assertEqual(buffers["paper_bits"], {"main": 128 * 64 * (112 + 2 * 7), "common": 2 * 100 * 112})
        self.assertEqual((buffers["pool"]["tiles"], buffers["pool"]["slots"]), (2, 100))
        self.assertLessEqual(buffers["pool"]["fullest"], 100)
        self.assertRegex(errors, r"hidden: [\d.]+ % on arrival, [\d.]+ % later\nbuffers for all pixels: main .*\n"
                                 r"2 pools of 100 slots, the fullest with \d+\n")
        # Totals cost nothing: they are there without --statistics too.
        plain = json.loads(self.run_command(*words, "--json")[0])
        self.assertEqual(plain["fragments"]["hidden_on_arrival"], fragments["hidden_on_arrival"])
        self.assertEqual(plain["memory"]["buffers"], buffers)

    def test_several_models(self):
        output, _ = self.run_command("render", "square.obj", "shape:cube", "-o", "a.png", "--size=16x16", "--json")
        self.assertEqual(json.loads(output)["triangles"]["in"], 14)

    def test_up_axis_turns_the_model(self):
        flat = "v -1 -1 0\nv 1 -1 0\nv 0 1 0.001\nf 1 2 3\n"  # lies on its back when z is up
        self.write("flat.obj", flat)
        lying = read_png(self.render("flat.obj", "--up-axis=z", "--view=top", "--background=transparent"))
        standing = read_png(self.render("flat.obj", "--view=front", "--background=transparent"))
        self.assertEqual([lying.bytes[i] > 0 for i in range(3, len(lying.bytes), 4)],
                         [standing.bytes[i] > 0 for i in range(3, len(standing.bytes), 4)])

    def test_summary_and_silence(self):
        _, errors = self.run_command("render", "square.obj", "-o", "a.png", "--size=16x16")
        self.assertRegex(errors, r"\Aa\.png: 16x16, 2 triangles, .*\nload [\d.]+ ms, .*total [\d.]+ ms\n\Z")
        self.assertEqual(self.run_command("render", "square.obj", "-o", "a.png", "--size=16x16", "-q"), (b"", ""))
        _, errors = self.run_command("render", "square.obj", "-o", "a.png", "--size=16x16", "-v")
        camera = re.search(r"camera: (.*)\n", errors)[1].split()
        self.assertEqual(self.render("square.obj", *camera, size="16x16"), self.render("square.obj", size="16x16"))
        self.assertNotIn("\033", errors)

    def test_locale_does_not_matter(self):
        expected = self.render("square.obj", "--fov=33.5")
        environment = {**os.environ, "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}
        self.run_command("render", "square.obj", "-o", "b.png", "--size=32x24", "--fov=33.5", env=environment)
        self.assertEqual(self.read("b.png"), expected)


class Failures(CommandTest):
    def test_input(self):
        self.assertIn("missing.obj", self.fails(3, "render", "missing.obj", "-o", "a.png"))
        self.write("broken.obj", "v 0 0 0\nv 1 0 0\nv zero 1 0\nf 1 2 3\n")
        self.assertIn("broken.obj:3", self.fails(3, "render", "broken.obj", "-o", "a.png"))
        self.assertIn("broken.obj:3", self.fails(3, "info", "broken.obj"))
        self.write("noise.bin", bytes(range(256)))
        self.fails(3, "render", "noise.bin", "-o", "a.png")
        self.fails(3, "render", ".", "-o", "a.png")
        self.fails(3, "render", "-", "-o", "a.png", input=b"")
        self.assertIn("name is empty", self.fails(3, "render", "", "-o", "a.png"))
        self.assertFalse(os.path.exists(self.path("a.png")))

    def test_a_shape_that_was_meant(self):
        for word in ("teapot?detail=3", "shpe:teapot?detail=3"):
            self.assertIn("did you mean shape:teapot?detail=3?", self.fails(3, "render", word, "-o", "a.png"))
        self.write("cube", "v 0 0\n")
        self.assertNotIn("did you mean", self.fails(3, "render", "cube", "-o", "a.png"))

    def test_no_triangles(self):
        self.write("points.obj", "v 1 2 3\n")
        self.assertIn("there is 1 vertex, but no faces; `blysk info`", self.fails(3, "render", "points.obj", "-o", "a.png"))
        self.assertIn("no faces", self.run_command("info", "points.obj")[0].decode())
        self.run_command("render", "points.obj", "square.obj", "-q", "-o", "a.png")
        self.assertIn("points.obj", self.fails(3, "render", "points.obj", "points.obj", "-o", "a.png"))

    def test_a_name_cannot_break_the_line(self):
        self.assertIn("mis?sing?[31m.obj", self.fails(3, "render", "mis\nsing\033[31m.obj", "-o", "a.png"))

    def test_output(self):
        before = sorted(os.listdir(self.folder))
        self.assertIn("nowhere", self.fails(4, "render", "square.obj", "-o", "nowhere/a.png"))
        os.mkdir(self.path("folder.png"))
        self.assertIn("folder.png", self.fails(4, "render", "square.obj", "-o", "folder.png"))
        self.fails(4, "render", "square.obj", "-o", "square.obj/a.png")
        self.assertEqual(sorted(os.listdir(self.folder)), sorted([*before, "folder.png"]))

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_full_disk(self):
        with open("/dev/full", "wb") as full:
            for words in (["methods"], ["info", "square.obj", "--json"], ["man"], ["--help"],
                          ["render", "square.obj", "-q", "-o", "-", "--format=png"]):
                done = subprocess.run([BLYSK, *words], cwd=self.folder, stdout=full, stderr=subprocess.PIPE)
                self.assertEqual(done.returncode, 4)
                self.assertRegex(done.stderr, rb"\Ablysk: error: standard output: [^\n]+\n\Z")
        self.fails(4, "render", "square.obj", "-q", "-o", "/dev/full", "--format=ppm")

    def test_existing_picture_stays_on_failure(self):
        self.write("a.png", b"precious")
        self.fails(3, "render", "missing.obj", "-o", "a.png")
        self.fails(2, "render", "square.obj", "-o", "a.png", "--fov=0")
        self.fails(5, "render", "square.obj", "-o", "a.png", "--max-triangles=1")
        self.assertEqual(self.read("a.png"), b"precious")

    def test_limits(self):
        self.assertIn("--max-triangles", self.fails(5, "render", "shape:sphere", "-o", "a.png", "--max-triangles", "5"))
        self.fails(5, "render", "square.obj", "square.obj", "-o", "a.png", "--max-triangles", "3")
        self.fails(5, "info", "square.obj", "--max-triangles", "1")
        wide = ("render", "square.obj", "-o", "a.png", "--size=16384x1", "--aov=fragments", "-q")
        self.assertIn("--aov-format", self.fails(5, *wide))
        self.run_command(*wide, "--aov-format=csv")
        self.assertIn("limit of 1024 bytes", self.fails(5, "render", "shape:sphere?detail=300", "-o", "a.png",
                                                        "--max-memory", "1K"))

    def test_reader_gone(self):
        for words in (["man"], ["render", "square.obj", "-q", "-o", "-", "--format=png"]):
            read_end, write_end = os.pipe()
            os.close(read_end)
            done = subprocess.run([BLYSK, *words], cwd=self.folder, stdout=write_end, stderr=subprocess.PIPE)
            os.close(write_end)
            self.assertEqual((done.returncode, done.stderr), (4, b""))

    def test_closed_standard_output(self):
        done = subprocess.run(["sh", "-c", '"$0" methods >&-', BLYSK], stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 4)
        done = subprocess.run(["sh", "-c", '"$0" render square.obj -q --size 8x8 -o a.png --json >&-', BLYSK],
                              cwd=self.folder, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 4)
        self.assertEqual(read_png(self.read("a.png")).width, 8)

    def test_interrupt_while_reading(self):
        process = self.start("render", "-", "-o", "a.png", stdin=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=10)
        self.assertEqual((process.returncode, errors), (130, b""))
        self.assertEqual(os.listdir(self.folder), ["square.obj"])

    def test_interrupt_while_rendering_leaves_what_was_there(self):
        self.write("a.png", b"precious")
        process = self.start("render", "square.obj", "-o", "a.png", "--repeat=100000", stderr=subprocess.PIPE)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=10)
        self.assertEqual(process.returncode, 130)
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.png", "square.obj"])
        self.assertEqual(self.read("a.png"), b"precious")

    def test_interrupt_while_writing_leaves_all_or_nothing(self):
        for attempt in range(3):
            process = self.start("render", "square.obj", "-q", "-o", "a.ppm", "--size=3000x3000")
            deadline = time.monotonic() + 20
            while process.poll() is None and time.monotonic() < deadline:
                if len(os.listdir(self.folder)) > 1:
                    time.sleep(0.002 * attempt)
                    process.send_signal(signal.SIGINT)
                    break
            process.wait(timeout=20)
            self.assertIn(process.returncode, (0, 130))
            left = sorted(os.listdir(self.folder))
            if left != ["square.obj"]:
                self.assertEqual(left, ["a.ppm", "square.obj"])
                self.assertEqual(os.path.getsize(self.path("a.ppm")), len("P6\n3000 3000\n255\n") + 3 * 3000 * 3000)
                os.remove(self.path("a.ppm"))


class Others(CommandTest):
    def test_info(self):
        output, errors = self.run_command("info", "square.obj")
        self.assertEqual(errors, "")
        self.assertRegex(output.decode(), r"triangles +2\n")
        data = json.loads(self.run_command("info", "square.obj", "--json")[0])
        self.assertEqual((data["triangles"], data["instances"], len(data["meshes"])), (2, 1, 1))
        self.assertEqual(data["bounds"], {"lo": [-1, -1, 0], "hi": [1, 1, 0], "size": [2, 2, 0]})
        for field in ("vertices", "materials", "textures", "lights", "cameras", "problems"):
            self.assertIn(field, data)
        self.assertEqual(json.loads(self.run_command("info", "-", "--json", input=SQUARE.encode())[0])["triangles"], 2)
        self.assertGreater(json.loads(self.run_command("info", "shape:xfighter", "--json")[0])["triangles"], 100)

    def test_methods(self):
        data = json.loads(self.run_command("methods", "--json")[0])
        kinds = {}
        for method in data["methods"]:
            kinds.setdefault(method["kind"], []).append(method)
        self.assertEqual(sorted(kinds), ["antialias", "lighting", "lobe", "shading"])
        table = self.run_command("methods")[0].decode()
        for kind, rows in kinds.items():
            self.assertEqual([row["default"] for row in rows], [True] + [False] * (len(rows) - 1))
            for row in rows:
                self.assertRegex(table, rf"(?m)^{kind} +{re.escape(row['name'])} ")
                self.render("square.obj", f"--{kind}", row["name"], size="8x8")

    def test_verify(self):
        output, errors = self.run_command("verify", "--threads=2")
        lines = output.decode().splitlines()
        self.assertGreaterEqual(len(lines), 12)
        for line in lines:
            self.assertRegex(line, r"^ok +\S+ +[0-9a-f]{64}$")
        self.assertIn(f"{len(lines)} scenes", errors)
        data = json.loads(self.run_command("verify", "--isa=scalar", "--threads=1", "--json")[0])
        self.assertTrue(data["ok"])
        self.assertEqual([scene["hashes"]["scalar"] for scene in data["scenes"]], [line[-64:] for line in lines])

    def test_verify_prints_its_own_source(self):
        with open(os.path.join(REPOSITORY, "apps", "blysk", "verify_hashes.inc"), "rb") as file:
            self.assertEqual(self.run_command("verify", "--print", "--isa=scalar")[0], file.read())

    def test_a_scene_of_verify_is_a_line_of_render(self):
        scene = json.loads(self.run_command("verify", "--isa=scalar", "--json")[0])["scenes"][0]
        words = scene["command"].split()[1:]
        data = json.loads(self.run_command(*words, "-o", "a.png", "--json", "-q")[0])
        self.assertEqual(data["sha256"], scene["published"])


class Completion(CommandTest):
    def complete(self, *words):
        """What bash offers for the last word."""
        line = " ".join(f"'{word}'" for word in words)
        script = (f'eval "$("{BLYSK}" completion bash)"; COMP_WORDS=(blysk {line}); COMP_CWORD={len(words)}; _blysk; '
                  'printf "%s\\n" "${COMPREPLY[@]}"')
        done = subprocess.run(["bash", "-c", script], capture_output=True, check=True)
        self.assertEqual(done.stderr, b"")
        return done.stdout.decode().split()

    def test_completion(self):
        self.assertEqual(self.complete("ren"), ["render"])
        self.assertLessEqual(set(SUBCOMMANDS), set(self.complete("")))
        self.assertEqual(self.complete("render", "--shad"), ["--shading"])
        self.assertIn("--threads", self.complete("info", "--"))
        self.assertNotIn("--shading", self.complete("info", "--"))
        self.assertEqual(self.complete("render", "--view", "fr"), ["front"])
        self.assertEqual(self.complete("render", "--view", "=", "fr"), ["front"])
        self.assertIn("bottom", self.complete("render", "--view", "="))
        self.assertEqual(self.complete("completion", ""), ["bash"])
        self.assertEqual(self.complete("render", "squ"), [])  # file names are bash's own
        self.assertEqual(self.complete("render", "-o", "squ"), [])
        self.assertEqual(self.complete("render", "shape", ":", "teap"), ["teapot"])
        self.assertIn("cube", self.complete("render", "shape", ":"))

    def test_bash_takes_the_script(self):
        script, _ = self.run_command("completion", "bash")
        done = subprocess.run(["bash", "-n"], input=script, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""))


if __name__ == "__main__":
    unittest.main()
