"""Running the command, and reading the pictures that it writes."""

import collections
import hashlib
import os
import struct
import subprocess
import tempfile
import unittest
import zlib

BLYSK = os.environ.get("BLYSK", "blysk")
REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

Picture = collections.namedtuple("Picture", "width height channels bytes")

SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\nf 1 3 4\n"


def read_png(data):
    """Every pixel of an 8-bit PNG without interlacing; each chunk's checksum is checked."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, header, kinds = 8, b"", None, []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        (checksum,) = struct.unpack(">I", data[at + 8 + length:at + 12 + length])
        assert checksum == zlib.crc32(kind + body), kind
        kinds.append(kind)
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    assert kinds[0] == b"IHDR" and kinds[-1] == b"IEND"
    width, height, depth, colour, _, _, interlaced = header
    assert (depth, interlaced) == (8, 0)
    channels = {0: 1, 2: 3, 6: 4}[colour]
    return Picture(width, height, channels, unfilter(zlib.decompress(packed), width * channels, channels))


def unfilter(raw, row_bytes, channels):
    rows, above = bytearray(), bytes(row_bytes)
    assert len(raw) % (row_bytes + 1) == 0
    for start in range(0, len(raw), row_bytes + 1):
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + row_bytes])
        for i in range(row_bytes):
            left = row[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            row[i] = (row[i] + predicted(kind, left, above[i], corner)) & 255
        rows += row
        above = row
    return bytes(rows)


def predicted(kind, left, up, corner):
    if kind < 4:
        return (0, left, up, (left + up) // 2)[kind]
    guess = left + up - corner
    return min((left, up, corner), key=lambda value: abs(guess - value))


def read_netpbm(data):
    """PPM or PFM as written here, three lines and the body: magic, width, height, body."""
    magic, size, _, body = data.split(b"\n", 3)
    width, height = size.split()
    return magic, int(width), int(height), body


def picture_hash(picture):
    """The hash that --json gives, out of the picture's own pixels."""
    pixels = picture.bytes
    if picture.channels == 3:
        pixels = b"".join(pixels[i:i + 3] + b"\xff" for i in range(0, len(pixels), 3))
    return hashlib.sha256(b"%dx%d\n" % (picture.width, picture.height) + pixels).hexdigest()


class CommandTest(unittest.TestCase):
    """Each test runs in a folder of its own, with a small square in square.obj."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="blysk-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("square.obj", SQUARE)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def start(self, *arguments, **options):
        return subprocess.Popen([BLYSK, *arguments], cwd=self.folder, **options)

    def run_command(self, *arguments, status=0, **options):
        """Runs it; gives (stdout as bytes, stderr as text)."""
        options.setdefault("stdout", subprocess.PIPE)
        done = subprocess.run([BLYSK, *arguments], cwd=self.folder, stderr=subprocess.PIPE, timeout=60, **options)
        errors = done.stderr.decode()
        self.assertEqual(done.returncode, status, f"blysk {' '.join(arguments)}\n{errors}")
        return done.stdout, errors

    def fails(self, status, *arguments, **options):
        """Runs what must fail with one line on stderr and none on stdout; gives that line."""
        output, errors = self.run_command(*arguments, status=status, **options)
        self.assertFalse(output)
        self.assertRegex(errors, r"\Ablysk: error: [^\n]+\n\Z")
        return errors

    def render(self, *arguments, name="out.png", size="32x24"):
        """Renders to `name` and gives the bytes of the picture file."""
        self.run_command("render", "-q", "-o", name, *([f"--size={size}"] if size else []), *arguments)
        return self.read(name)
