#!/usr/bin/env python3
"""Prints src/image/srgb_table.inc: the sRGB transfer function (IEC 61966-2-1) as tables.

kSrgbThresholds  the smallest float whose exactly rounded 8-bit code is 1, 2, ... 255
kSrgbSegments    a line for every eighth of an octave of [2^-13, 1): offset in units of 1/128 code in the upper 16 bits,
                 slope per 1/256 of the segment in units of 1/65536 code in the lower 16 bits

Thresholds and linear values are computed with 60 decimal digits. Each line is searched for: of those whose
largest distance from the true curve is within kBound it is the one that gives most floats their exactly rounded code.

    tools/make_srgb_table.py > src/image/srgb_table.inc
"""
import struct
import sys
from decimal import Decimal, getcontext

getcontext().prec = 60

FIRST_EXPONENT = -13
SEGMENTS = -FIRST_EXPONENT * 8
STEPS = 256
BOUND = 0.55  # codes; 0.5 is what rounding alone costs
OFFSET_SEARCH = 12
SLOPE_SEARCH = 24


def decode(code):
    """Linear light of a code 0..255, which may be a fraction."""
    v = Decimal(code) / 255
    if v <= Decimal("0.04045"):
        return v / Decimal("12.92")
    return ((v + Decimal("0.055")) / Decimal("1.055")) ** Decimal("2.4")


def encode(x):
    """The true code of linear light, not rounded; in double precision, for the search."""
    return 255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055)


def bits_to_float(bits):
    return struct.unpack("<f", struct.pack("<I", bits))[0]


def float_bits(value):
    """Bits of the float nearest to a positive value; the conversion through double is settled by neighbours."""
    bits = struct.unpack("<I", struct.pack("<f", float(value)))[0]
    return min((bits - 1, bits, bits + 1), key=lambda b: abs(Decimal(bits_to_float(b)) - value)) if value else 0


def float_bits_up(value):
    """Bits of the smallest float that is not below a positive value."""
    bits = float_bits(value)
    return bits if Decimal(bits_to_float(bits)) >= value else bits + 1


def literal(bits):
    mantissa, exponent = bits_to_float(bits).hex().split("p")
    return f"{mantissa.rstrip('0')}p{exponent}f" if bits else "0.0f"


THRESHOLDS = [float_bits_up(decode(Decimal(2 * k - 1) / 2)) for k in range(1, 256)]


class Segment:
    """Its steps: the true code at both ends, and how many floats of the step round to which code."""

    def __init__(self, index):
        first = ((127 + FIRST_EXPONENT) << 23) + (index << 20)
        self.ends = []
        self.codes = []
        code = sum(1 for t in THRESHOLDS if t <= first)
        for step in range(STEPS):
            lo, hi = first + (step << 12), first + ((step + 1) << 12) - 1
            self.ends.append((encode(bits_to_float(lo)), encode(bits_to_float(hi))))
            counts, at = {}, lo
            while at <= hi:
                end = min(hi + 1, THRESHOLDS[code]) if code < 255 else hi + 1
                counts[code] = counts.get(code, 0) + end - at
                at = end
                if code < 255 and at == THRESHOLDS[code]:
                    code += 1
            self.codes.append(counts)

    def judge(self, offset, slope, limit):
        """(floats with another code than the exactly rounded one, largest distance), or None if beyond a limit."""
        missed, worst = 0, 0.0
        for step in range(STEPS):
            code = ((offset << 9) + slope * step) >> 16
            low, high = self.ends[step]
            worst = max(worst, abs(code - low), abs(code - high))
            missed += 4096 - self.codes[step].get(code, 0)
            if worst > BOUND or missed > limit:
                return None
        return missed, worst

    def fit(self):
        low, high = self.ends[0][0], self.ends[-1][1]
        slope0 = round((high - low) * 256)
        best = None
        for offset in range(round((low + 0.5) * 128) - OFFSET_SEARCH, round((low + 0.5) * 128) + OFFSET_SEARCH + 1):
            for slope in range(max(0, slope0 - SLOPE_SEARCH), slope0 + SLOPE_SEARCH + 1):
                found = self.judge(offset, slope, best[0] if best else STEPS * 4096)
                if found and (best is None or found < best[:2]):
                    best = (*found, offset, slope)
        if best is None:
            sys.exit("no line stays within the bound")
        return best


def print_array(declaration, items, per_line):
    print(f"{declaration} = {{")
    for i in range(0, len(items), per_line):
        print("    " + ", ".join(items[i:i + per_line]) + ",")
    print("};")


def main():
    fits = [Segment(i).fit() for i in range(SEGMENTS)]
    missed = sum(f[0] for f in fits)
    print("// Made by tools/make_srgb_table.py.")
    print(f"// Segments: at most {max(f[1] for f in fits):.4f} codes from the true curve; "
          f"{100 * missed / (SEGMENTS << 20):.2f} % of the floats")
    print("// in [2^-13, 1) get a neighbour of their exactly rounded code.")
    print_array("constexpr float kSrgbThresholds[255]", [literal(b) for b in THRESHOLDS], 4)
    print_array(f"const std::uint32_t kSrgbSegments[{SEGMENTS}]", [f"0x{f[2] << 16 | f[3]:08x}" for f in fits], 8)


main()
