"""Numbers of the actuators that the cases use: from `antrieb data CODE --json` into actuators.json.

    python3 validation/differential/actuators.py target/release/antrieb

`I_0m` is the largest continuous stall current over the ratios of the same motor. The thermal constants are those of
data/cha/family.toml: w = R_ha/(R_wh + R_ha), tau_w and tau_h in seconds.
"""

import json
import subprocess
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).parent
PLACE = HERE / "actuators.json"
FAMILY = HERE.parent.parent / "data" / "cha" / "family.toml"
THERMAL = {"housing_share": "w", "stall_loss_factor": "stall_loss_factor", "tau_w": "tau_w", "tau_h": "tau_h"}
CODES = """CHA-14A-50-E-RES CHA-14A-100-H-RES CHA-17A-80-E-M128S CHA-17A-50-H-RES CHA-20A-30-H-C1024
CHA-20A-100-H-C1024 CHA-20A-160-H-M512P-B CHA-25A-50-H-C1024 CHA-25A-160-H-C1024 CHA-32A-50-H-C1024
CHA-32A-100-H-M512P CHA-40A-80-H-C1024 CHA-50A-120-H-C1024 CHA-58A-160-H-C1024-B""".split()
RATIOS = (30, 50, 80, 100, 120, 160)
PLAIN = ["T_max", "T_0", "I_0", "I_max", "k_Tout", "k_TM", "k_EM", "R_LL", "L_LL", "p", "J_out", "n_mot_max", "U_DCmax"]
PLAIN += ["d_p", "R", "C", "C_0", "K_B", "T_1", "T_2", "K_1", "K_2", "K_3"]
SCALE = {"mH": 1e-3, "10^-3 A/min^-1": 1e-3, "10^3 Nm/rad": 1e3}


def cells(program, code):
    answer = subprocess.run([program, "data", code, "--json"], capture_output=True, text=True)
    if answer.returncode != 0:
        return None
    found = {}
    for section in json.loads(answer.stdout)["sections"]:
        for cell in section["values"]:
            value = cell["value"] if cell["checks_use"] is None else cell["checks_use"]
            if isinstance(value, float) and cell["unit"] in SCALE:
                value = float(f"{value * SCALE[cell['unit']]:.12g}")
            found.setdefault(cell["symbol"], []).append((cell["condition"], value))
    return found


def thermal(size, winding):
    """The row cells of the family for one drive; one cell stands for all."""
    family = tomllib.loads(FAMILY.read_text())
    names = {f"CHA-{size}", f"CHA-{size}-{'E' if winding == 'E' else 'H/N'}"}
    (column,) = (index for index, name in enumerate(family["columns"]) if name in names)
    rows = {row["symbol"]: row["cells"] for row in family["row"]}
    return {ours: float(cells[column % len(cells)].replace(",", ".")) for symbol, ours in THERMAL.items() for cells in [rows[symbol]]}


def actuator(program, code):
    found = cells(program, code)
    if found is None:
        raise SystemExit(f"no data for {code}")
    size, ratio, winding = code.split("-")[1:4]
    result = {"i": float(ratio), "bearing": found["bearing_type"][0][1]}
    result |= {symbol: found[symbol][0][1] for symbol in PLAIN if symbol in found}
    if code.endswith("-B"):
        result |= {"J_out": found["J_out_brake"][0][1], "U_Br": found["U_Br"][0][1], "I_HBr": found["I_HBr"][0][1]}
    result["I_NLS"] = next(v for c, v in found["I_NLS"] if "-40" not in c and "-20" not in c)
    result |= {f"K_INL_{t}": next(v for c, v in found["K_INL"] if c.startswith(t)) for t in ("30", "80")}
    others = (cells(program, code.replace(f"-{ratio}-", f"-{other}-", 1)) for other in RATIOS)
    result["I_0m"] = max(other["I_0"][0][1] for other in others if other)
    result["stall_counts_I_NLS"] = winding != "E"
    result["curves_published"] = size == "20A"
    return result | thermal(size, winding)


if __name__ == "__main__":
    actuators = {code: actuator(sys.argv[1], code) for code in CODES}
    PLACE.write_text(json.dumps(actuators, indent=1) + "\n")
