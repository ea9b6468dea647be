#!/usr/bin/env python3
"""What `vesicle tradeoff` promised in the folders given, beside the truth where that is known."""
import json
import pathlib
import sys

print("| scene | recommended for 1e-3 | CPU | observable | promised | true | true/promised |")
print("|---|---|---|---|---|---|---|")
for folder in sys.argv[1:]:
    result = json.loads((pathlib.Path(folder) / "tradeoff.json").read_text())
    best = result["recommended"]
    settings = " ".join(str(value) for value in best["settings"].values())
    for name, o in best["observables"].items():
        true = o.get("true_error")
        end = f"{true:.1e} | {true / o['promised_error']:.2f}" if true is not None else "unknown |"
        print(f"| {pathlib.Path(folder).name} | {settings} | {best['cpu_seconds']:.1f} s | `{name}` "
              f"| {o['promised_error']:.1e} | {end} |")
