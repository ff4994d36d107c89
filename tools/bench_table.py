#!/usr/bin/env python3
"""bench_table.py FOLDER SIZE JOBS: what tools/bench-peers has measured, as Markdown on standard output."""

import json
import pathlib
import re
import statistics
import subprocess
import sys

QUIET = 0.25  # cores that other processes may use before a run counts as disturbed


def runs_of(report, label):
    """All good runs of a label, the undisturbed ones alone if there are any."""
    good = [run for run in report[label] if run["rc"] == 0]
    if not good:
        sys.exit(f"bench_table: {label} failed: {report[label][-1]['out'][-400:]}")
    return [run for run in good if run["other"] < QUIET] or good


def disturbed(reports):
    every = [run for report in reports for runs in report.values() for run in runs]
    return sum(run["other"] >= QUIET for run in every), len(every)


def number_after(run, word):
    found = re.search(re.escape(word) + r"\s*([0-9.]+)", run["out"])
    if not found:
        sys.exit(f"bench_table: no '{word}' in: {run['out'][-400:]}")
    return float(found.group(1))


def median_after(runs, word):
    return statistics.median(number_after(run, word) for run in runs)


def ratio(report, over, under, value):
    """Median of the ratios within a turn: what slows a host for seconds slows both."""
    turns = [turn for turn in zip(report[over], report[under]) if all(run["rc"] == 0 for run in turn)]
    quiet = [turn for turn in turns if all(run["other"] < QUIET for run in turn)]
    return statistics.median(value(a) / value(b) for a, b in quiet or turns)


def frame_time(run):
    return number_after(run, "median")


def ms(value):
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def frame_rows(reports):
    print("| scene | llvmpipe, ms | Blysk, ms | ratio | Blysk, one thread, ms | scaling | covered, both |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    for name, report in reports:
        rival, ours, one = (runs_of(report, label) for label in ("rival", "ours", "one"))
        a, b, c = (median_after(runs, "median") for runs in (rival, ours, one))
        gain, scaling = ratio(report, "rival", "ours", frame_time), ratio(report, "one", "ours", frame_time)
        covered = [median_after(runs, "covered") for runs in (rival, ours)]
        print(f"| {name} | {ms(a)} | {ms(b)} | {gain:.1f} | {ms(c)} | {scaling:.2f} | "
              f"{covered[0]:.1f} %, {covered[1]:.1f} % |")


def stage_rows(reports):
    print("| scene | triangles | drawn | geometry, ms | tiles, ms | Mtriangles/s | memory, bytes a triangle |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    for name, report in reports:
        one = runs_of(report, "one")
        triangles = int(re.search(r" (\d+) tri ", one[0]["out"]).group(1))
        drawn = int(number_after(one[0], "drawn"))
        rate = float(re.search(r"([0-9.]+) Mtri/s", one[0]["out"]).group(1))
        memory = float(re.search(r"([0-9.]+) B/tri", one[0]["out"]).group(1))
        print(f"| {name} | {triangles:,} | {drawn:,} | {ms(median_after(one, 'geometry'))} | "
              f"{ms(median_after(one, 'tiles'))} | {rate:.1f} | {memory:,.0f} |")


def process_rows(reports, start):
    def of(runs):
        return statistics.median(run["wall"] for run in runs), max(run["rss"] for run in runs)

    print("| model | f3d, s | MB | Blysk, s | MB | ratio of time | of memory |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    for name, report in reports:
        (a, a_mb), (b, b_mb) = of(runs_of(report, "rival")), of(runs_of(report, "ours"))
        gain = ratio(report, "rival", "ours", lambda run: run["wall"])
        print(f"| {name} | {a:.2f} | {a_mb:.0f} | {b:.3f} | {b_mb:.0f} | {gain:.1f} | {a_mb / b_mb:.1f} |")
    wall, mb = of(runs_of(start, "version"))
    print(f"| `--version` | | | {wall:.4f} | {mb:.0f} | | |")


def processor():
    text = pathlib.Path("/proc/cpuinfo").read_text()
    found = re.search(r"model name\s*:\s*(.*)", text)
    return f"{found.group(1) if found else 'unknown processor'}, {len(re.findall('^processor', text, re.M))} processors"


def revision():
    answer = subprocess.run(["git", "describe", "--always", "--dirty"], capture_output=True, text=True, check=False)
    return answer.stdout.strip() or "unknown"


def main():
    folder, size, jobs = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    written = {path.stem: json.loads(path.read_text()) for path in folder.glob("*.json")}

    def group(prefix, names):
        return [(name, written[f"{prefix}-{name}"]) for name in names]

    frames = group("frame", ["quad", "bunny", "dragon", "sphere:1e6", "sphere:1e7", "tris:100:10", "tris:100:10:b2f"])
    processes = group("process", ["bunny.obj", "dragon.ply", "sphere.stl"])
    rival = frames[0][1]["rival"][0]["out"]
    renderer = re.search(r"llvmpipe \([^)]*\)", rival)
    count, total = disturbed(written.values())
    print(f"{processor()}; revision {revision()}; {size}, {jobs} threads; {renderer.group(0) if renderer else rival}.")
    print(f"{count} of {total} runs were disturbed by other processes"
          f"{': the figures below are noisy' if count * 4 > total else ''}.\n")
    print("**Frames**\n")
    frame_rows(frames)
    print("\n**Stages of Blysk's frame, one thread**\n")
    stage_rows(frames)
    print("\n**Whole processes, file to PNG**\n")
    process_rows(processes, written["start"])
    print("\n**The machine** (arrays in the third-level cache or memory; triad reads two and writes one)\n")
    print("```\n" + (folder / "machine.txt").read_text().strip() + "\n```")


if __name__ == "__main__":
    main()
