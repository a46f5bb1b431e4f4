"""Random projects whose loads on the flange follow from the mechanism, and such with a stage before the mechanism."""

from projects import Author, NORMALISED, short, table

PLAN = [(kind, None) for kind in ("arm", "turntable", "belt", "conveyor", "screw", "slider_crank") for _ in range(2)]
PLAN += [("load", "belt"), ("arm", "gear"), ("arm", "belt"), ("belt", "gear"), ("slider_crank", "belt"), ("table", "coupling")]


def behind(data, ratio):
    """What an actuator gives behind a ratio."""
    more = {key: data[key] * ratio for key in ("T_max", "T_0", "i")}
    return data | more | {"J_out": data["J_out"] * ratio**2}


class Further(Author):
    """As Author, with `[stage]` and the keys of `[bearing]` that let the mechanism count."""

    def __init__(self, rng, kind, data, stage):
        self.stage, self.own = stage, data
        ratio = float(short(rng.uniform(1.3, 4))) if stage in ("belt", "gear") else 1.0
        super().__init__(rng, kind, behind(data, ratio) if stage else data)
        self.ratio = ratio

    def stage_keys(self):
        own = self.own["J_out"]
        keys = {"kind": self.stage}
        if self.stage != "coupling":
            keys |= {"ratio": self.ratio, "pitch_diameter": f"{short(self.between(40, 120))} mm"}
            keys |= {"efficiency": float(short(self.between(0.8, 0.98)))}
        if self.chance(0.7):
            keys["efficiency_back"] = float(short(self.between(0.3, 0.95)))
            keys.setdefault("efficiency", 0.96)
        keys["inertia_driving"] = f"{short(self.between(0.01, 0.2) * own)} kg m^2"
        keys["inertia_driven"] = f"{short(self.between(0.01, 0.2) * own * self.ratio**2)} kg m^2"
        keys["stiffness"] = f"{short(self.between(5e3, 5e4))} N m/rad"
        return keys

    def mounting(self, moved):
        keys = {"mechanism": self.pick("add", "replace"), "overhang": f"{short(self.between(10, 120))} mm"}
        toothed = self.stage == "gear" or (self.stage is None and self.kind == "belt" and self.chance(0.5))
        if toothed:
            keys |= {"pressure_angle": "20 deg"} | ({"helix_angle": "19.5 deg"} if self.chance(0.6) else {})
        elif self.stage == "belt" or (self.stage is None and self.kind in ("belt", "conveyor")):
            keys["belt_tension"] = f"{short(self.between(50, 900))} N"
        if self.stage is None:
            if "payload_distance" in moved:
                keys["payload_overhang"] = f"{short(self.between(20, 200))} mm"
            if self.kind == "screw" or self.chance(0.3):
                keys["flange_share"] = float(short(self.between(0.2, 1)))
            if self.kind in ("belt", "conveyor", "screw", "slider_crank") and (self.kind == "screw" or self.chance(0.6)):
                keys |= {"wheel_mass": f"{short(self.between(0.3, 4))} kg", "axis_tilt": f"{short(self.between(5, 90))} deg"}
        return keys

    def text(self, laws):
        """The project with its further tables."""
        text = self.project(laws)
        head, _, needs = text.rpartition("\n[requirements]")
        head, found, _ = head.partition("\n[bearing]")
        moved = {"payload_distance": ""} if "payload_distance" in text else {}
        keys = self.mounting(moved)
        if self.stage != "coupling" and (self.kind, self.stage) != ("table", None):
            adds = keys["mechanism"] == "add"
            stated = self.forces() if found and adds and self.chance(0.6) else {}
            more = {"load_factor": float(short(self.between(1, 2), 3)), "operating_condition": "shock"}
            head += table("[bearing]", keys | stated | more)
        elif self.stage and "[motion.bearing]" in head:
            head += table("[bearing]", {"mechanism": "ignore"})
        if self.stage:
            head += table("[stage]", self.stage_keys())
        return head + "\n[requirements]" + needs


def further(actuators, rng, bearable, results):
    """Each case with its expected results."""
    codes = list(actuators)
    for number, (kind, stage) in enumerate(PLAN):
        laws = [(*NORMALISED, "jerk", "manual", "through", "recorded")[(3 * number + k) % 11] for k in range(1 + number % 2)]
        for _ in range(200):
            code = codes[int(rng.integers(len(codes)))]
            author = Further(rng, kind, actuators[code] | {"brake": code.endswith("-B")}, stage)
            text = author.text(laws)
            if bearable(text, author.files, code):
                break
        else:
            raise SystemExit(f"no bearable project for {kind} behind {stage}")
        yield {
            "name": f"{'stage' if stage else 'flange'} {number + 1:02} {kind}: {', '.join(laws)}",
            "code": code,
            "project": text,
            "files": author.files,
            "rotations": author.rotations(),
            "mirror": author.mirror,
            "expect": results(text, author.files, code),
        }
