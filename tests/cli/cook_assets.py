#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cooks the twelve real assets with a recipe, checks each bundle and prints a table.

    CRUMPLE=build/crumple tests/cli/cook_assets.py [--recipe car_body] [--json FILE] [NAME...]
"""
import argparse
import json
import pathlib
import sys
import tempfile

import program

ASSETS = [
    ("spot_shell.obj", "spot_visual.obj"),
    ("spot_shell_painted.ply", "spot_visual.obj"),
    ("bob_shell.obj", "bob_visual.ply"),
    ("suv_shell.obj", "suv_visual.obj"),
    ("prius_shell.obj", "prius_visual.obj"),
    ("kenney_truck_shell.obj", "kenney_truck_visual.glb"),
    ("simplebridge_cage.obj", "simplebridge_visual.obj"),
    ("femfx_car_body_shell.obj", None),
    ("femfx_car_all_shell.obj", None),
    ("femfx_tractor_tire_shell.obj", None),
    ("mengersponge3_vertexcolours.glb", None),
    ("kwxport_vcolors.dae", None),
]
COLUMNS = ["asset", "exit", "check", "nodes", "tets", "volume error %", "outside", "cpu s", "wall s", "peak MB", "findings"]


def stage_of(report, name):
    return next((stage["report"] for stage in report["stages"] if stage["name"] == name), {})


def cook(shell, visual, recipe, folder):
    """One row of the table, as a dictionary."""
    output = pathlib.Path(folder) / (pathlib.Path(shell).stem + ".hdf")
    words = ["cook", recipe, "--shell", program.DATA / "open" / shell, "-o", output, "--format", "json", "-q"]
    if visual:
        words += ["--visual", program.DATA / "open" / visual]
    process = program.run(*words)
    row = {"asset": shell + (" + " + visual if visual else ""), "exit": process.returncode, "check": None}
    if process.returncode != 0:
        row["error"] = process.stderr.strip()
        return row
    report = json.loads(process.stdout)
    bundle = stage_of(report, "bake")["bundle"]
    row["check"] = program.run("check", output).returncode
    row["nodes"], row["tets"] = bundle["nodes"], bundle["tets"]
    row["volume error %"] = round(100 * stage_of(report, "gates")["figures"]["fidelity"]["volume_error"], 3)
    row["outside"] = sum(visual["outside"] for visual in bundle["visuals"])
    row["cpu s"] = round(report["usage"]["cpu_s"], 3)
    row["wall s"] = round(report["usage"]["wall_s"], 3)
    row["peak MB"] = round(report["usage"]["peak_memory_mb"], 1)
    findings = [finding for stage in report["stages"] for finding in stage["findings"]]
    row["findings"] = " ".join(sorted({finding["code"] for finding in findings}))
    return row


def main():
    parser = argparse.ArgumentParser(description="Cooks the twelve real assets.")
    parser.add_argument("names", nargs="*", help="only shells whose name holds one of these")
    parser.add_argument("--recipe", default="car_body")
    parser.add_argument("--json", help="write the rows")
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        print("| " + " | ".join(COLUMNS) + " |\n" + "|---" * len(COLUMNS) + "|")
        for shell, visual in ASSETS:
            if options.names and not any(name in shell for name in options.names):
                continue
            rows.append(cook(shell, visual, options.recipe, folder))
            print("| " + " | ".join(str(rows[-1].get(column, rows[-1].get("error", ""))) for column in COLUMNS) + " |", flush=True)
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(rows, indent=1) + "\n")
    return 0 if all(row["exit"] == 0 and row["check"] == 0 for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
