"""A project as typed objects: every key of the project file is a keyword of a class.

This file is written from the description of the keys by `cargo xtask snapshots`; do not edit it. A quantity is a text with its
unit, `"30 kg"`, `antrieb.q(30, "kg")` or a quantity of pint; a bare number is refused. What is not given is not in the file.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from antrieb._axis import BaseAxis, BaseProject
from antrieb._quantity import Quantity
from antrieb._section import Kind, Load as LoadOrMechanism, Mechanism, ReturnMove, Section, Segment



class Load(LoadOrMechanism):
    """Moved load, referred to the output; or [mechanism.…]."""

    __slots__ = ()
    _TABLE = "load"
    _NEEDED = ("inertia",)
    _KEYS = {
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
    }

    inertia: str
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None

    def __init__(
        self,
        *,
        inertia: Quantity,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
    ) -> None:
        """Args:
            inertia: J_L, moment of inertia of the load at the output. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
        """
        self._begin(
            inertia=inertia,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
        )


class Body(Section):
    """Solid bodies as tables; or bodies."""

    __slots__ = ()
    _TABLE = "mechanism.turntable.body"
    _PLACES = ("shape",)
    _NEEDED = ("shape",)
    _KEYS = {
        "shape": Kind("word", words=("cylinder", "disc", "tube", "box", "cone", "sphere", "point", "rod",)),
        "diameter": Kind("quantity", example="50 mm"),
        "length": Kind("quantity", example="50 mm"),
        "outer": Kind("quantity", example="80 mm"),
        "inner": Kind("quantity", example="60 mm"),
        "a": Kind("quantity", example="50 mm"),
        "b": Kind("quantity", example="50 mm"),
        "height": Kind("quantity", example="50 mm"),
        "axis": Kind("word", words=("parallel", "perpendicular",)),
        "mass": Kind("quantity", example="3.2 kg"),
        "density": Kind("quantity", example="7850 kg/m^3"),
        "distance": Kind("quantity", example="50 mm"),
        "angle": Kind("quantity", example="90 deg"),
        "count": Kind("integer", example="3"),
    }

    shape: Literal["cylinder", "disc", "tube", "box", "cone", "sphere", "point", "rod"]
    diameter: str | None
    length: str | None
    outer: str | None
    inner: str | None
    a: str | None
    b: str | None
    height: str | None
    axis: Literal["parallel", "perpendicular"] | None
    mass: str | None
    density: str | None
    distance: str | None
    angle: str | None
    count: int | None

    def __init__(
        self,
        shape: Literal["cylinder", "disc", "tube", "box", "cone", "sphere", "point", "rod"],
        *,
        diameter: Quantity | None = None,
        length: Quantity | None = None,
        outer: Quantity | None = None,
        inner: Quantity | None = None,
        a: Quantity | None = None,
        b: Quantity | None = None,
        height: Quantity | None = None,
        axis: Literal["parallel", "perpendicular"] | None = None,
        mass: Quantity | None = None,
        density: Quantity | None = None,
        distance: Quantity | None = None,
        angle: Quantity | None = None,
        count: int | None = None,
    ) -> None:
        """Args:
            shape: Shape of the body.
            diameter: Diameter of a round body: cylinder, disc, cone (base) or sphere. Length such as `"50 mm"`, above zero.
            length: Length along the body's own axis. Length such as `"50 mm"`, above zero.
            outer: Outer diameter of a tube. Length such as `"80 mm"`, above zero.
            inner: Inner diameter of a tube. Length such as `"60 mm"`, zero or more.
            a: First side of a box, across the axis of rotation. Length such as `"50 mm"`, above zero.
            b: Second side of a box, across the axis of rotation. Length such as `"50 mm"`, above zero.
            height: Height of box or cone along the axis of rotation. Length such as `"50 mm"`, above zero.
            axis: Orientation of a round body to the axis of rotation: cylinder, disc or tube; default: parallel.
            mass: Mass of one body; or density. Mass such as `"3.2 kg"`, above zero.
            density: Density; or mass. Density such as `"7850 kg/m^3"`, above zero.
            distance: Distance of the centre of mass from the axis of rotation; default: zero. Length such as `"50 mm"`, zero or more.
            angle: Direction of the centre of mass in the plane of rotation; default: zero. Angle such as `"90 deg"`.
            count: Number of equal bodies, evenly spaced on the circle; default 1. 1 to 4294967295.
        """
        self._begin(
            shape=shape,
            diameter=diameter,
            length=length,
            outer=outer,
            inner=inner,
            a=a,
            b=b,
            height=height,
            axis=axis,
            mass=mass,
            density=density,
            distance=distance,
            angle=angle,
            count=count,
        )


class Turntable(Mechanism):
    """Turntable or drum of solid bodies."""

    __slots__ = ()
    _TABLE = "mechanism.turntable"
    _KEYS = {
        "body": Kind("tables", table="Body"),
        "bodies": Kind("texts"),
        "axis_tilt": Kind("quantity", example="90 deg"),
        "start_angle": Kind("quantity", example="90 deg"),
        "angle": Kind("alias", of_key="start_angle"),
        "payload_distance": Kind("quantity", example="50 mm"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    body: tuple[Body, ...] | None
    bodies: tuple[str, ...] | None
    axis_tilt: str | None
    start_angle: str | None
    payload_distance: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        body: Sequence[Body] | None = None,
        bodies: Sequence[str] | None = None,
        axis_tilt: Quantity | None = None,
        start_angle: Quantity | None = None,
        angle: Quantity | None = None,
        payload_distance: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            body: Solid bodies as tables; or bodies.
            bodies: Solid bodies as texts, one each, with shape and dimensions.
            axis_tilt: Tilt of the rotation axis from the vertical; default: vertical, listed as assumed. Angle such as `"90 deg"`.
            start_angle: Position at the beginning of the motion; default: zero. Angle such as `"90 deg"`.
            angle: Another name of `start_angle`.
            payload_distance: Distance of the payload of a segment from the axis. Length such as `"50 mm"`, zero or more.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            body=body,
            bodies=bodies,
            axis_tilt=axis_tilt,
            start_angle=start_angle,
            angle=angle,
            payload_distance=payload_distance,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class Arm(Mechanism):
    """Unbalanced arm."""

    __slots__ = ()
    _TABLE = "mechanism.arm"
    _NEEDED = ("mass",)
    _KEYS = {
        "shape": Kind("word", words=("rod", "bar", "taper", "point",)),
        "length": Kind("quantity", example="600 mm"),
        "width": Kind("quantity", example="80 mm"),
        "mass": Kind("quantity", example="3.2 kg"),
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "centre_distance": Kind("quantity", example="50 mm"),
        "payload_distance": Kind("quantity", example="50 mm"),
        "axis_tilt": Kind("quantity", example="90 deg"),
        "start_angle": Kind("quantity", example="90 deg"),
        "angle": Kind("alias", of_key="start_angle"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    shape: Literal["rod", "bar", "taper", "point"] | None
    length: str | None
    width: str | None
    mass: str
    inertia: str | None
    centre_distance: str | None
    payload_distance: str | None
    axis_tilt: str | None
    start_angle: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        shape: Literal["rod", "bar", "taper", "point"] | None = None,
        length: Quantity | None = None,
        width: Quantity | None = None,
        mass: Quantity,
        inertia: Quantity | None = None,
        centre_distance: Quantity | None = None,
        payload_distance: Quantity | None = None,
        axis_tilt: Quantity | None = None,
        start_angle: Quantity | None = None,
        angle: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            shape: Shape of the arm; inertia and centre of mass follow from it and need not be stated; default with a length: rod.
            length: Length of the arm from the axis to its end. Length such as `"600 mm"`, above zero.
            width: Width of a bar, across the arm in the plane of rotation. Length such as `"80 mm"`, above zero.
            mass: Mass of the arm. Mass such as `"3.2 kg"`, zero or more.
            inertia: Moment of inertia of the arm about the axis, without payload. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            centre_distance: Distance of the arm's centre of mass from the axis. Length such as `"50 mm"`, zero or more.
            payload_distance: Distance of the payload of a segment from the axis; default: the length of the arm, if it is stated. Length such as `"50 mm"`, zero or more.
            axis_tilt: Tilt of the rotation axis from the vertical; default: 90 deg, a horizontal axis, listed as assumed. Angle such as `"90 deg"`.
            start_angle: Position at the beginning of the motion; default: zero, listed as assumed. Angle such as `"90 deg"`.
            angle: Another name of `start_angle`.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            shape=shape,
            length=length,
            width=width,
            mass=mass,
            inertia=inertia,
            centre_distance=centre_distance,
            payload_distance=payload_distance,
            axis_tilt=axis_tilt,
            start_angle=start_angle,
            angle=angle,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class Screw(Mechanism):
    """Screw with slide."""

    __slots__ = ()
    _TABLE = "mechanism.screw"
    _NEEDED = ("lead", "mass",)
    _KEYS = {
        "lead": Kind("quantity", example="10 mm"),
        "mass": Kind("quantity", example="3.2 kg"),
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "inclination": Kind("quantity", example="90 deg"),
        "counterweight": Kind("quantity", example="3.2 kg"),
        "friction_force": Kind("quantity", example="500 N"),
        "friction_coefficient": Kind("number", example="0.05"),
        "process_force": Kind("quantity", example="500 N"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    lead: str
    mass: str
    inertia: str | None
    inclination: str | None
    counterweight: str | None
    friction_force: str | None
    friction_coefficient: float | None
    process_force: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        lead: Quantity,
        mass: Quantity,
        inertia: Quantity | None = None,
        inclination: Quantity | None = None,
        counterweight: Quantity | None = None,
        friction_force: Quantity | None = None,
        friction_coefficient: float | None = None,
        process_force: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            lead: Travel per revolution. Lead such as `"10 mm"`, above zero.
            mass: Moved mass. Mass such as `"3.2 kg"`, zero or more.
            inertia: Moment of inertia of the parts rotating with the output; if not stated, listed as assumed. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            inclination: Angle of the positive direction above the horizontal; 90 deg is upwards; default: horizontal, listed as assumed. Angle such as `"90 deg"`.
            counterweight: Counterweight; moves with the load and reduces it by its weight; on a hoist with as many falls as the load. Mass such as `"3.2 kg"`, zero or more.
            friction_force: Friction force of seals and guides. Force such as `"500 N"`, zero or more.
            friction_coefficient: Friction coefficient of the guide; default 0. 0 to 10.
            process_force: Process force along the guide, against the positive direction; does not change sign with the motion. Force such as `"500 N"`.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            lead=lead,
            mass=mass,
            inertia=inertia,
            inclination=inclination,
            counterweight=counterweight,
            friction_force=friction_force,
            friction_coefficient=friction_coefficient,
            process_force=process_force,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class Belt(Mechanism):
    """Belt, or rack and pinion, with slide."""

    __slots__ = ()
    _TABLE = "mechanism.belt"
    _NEEDED = ("pulley_diameter", "mass",)
    _KEYS = {
        "pulley_diameter": Kind("quantity", example="50 mm"),
        "mass": Kind("quantity", example="3.2 kg"),
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "inclination": Kind("quantity", example="90 deg"),
        "counterweight": Kind("quantity", example="3.2 kg"),
        "friction_force": Kind("quantity", example="500 N"),
        "friction_coefficient": Kind("number", example="0.05"),
        "process_force": Kind("quantity", example="500 N"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    pulley_diameter: str
    mass: str
    inertia: str | None
    inclination: str | None
    counterweight: str | None
    friction_force: str | None
    friction_coefficient: float | None
    process_force: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        pulley_diameter: Quantity,
        mass: Quantity,
        inertia: Quantity | None = None,
        inclination: Quantity | None = None,
        counterweight: Quantity | None = None,
        friction_force: Quantity | None = None,
        friction_coefficient: float | None = None,
        process_force: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            pulley_diameter: Pitch diameter of the driving pulley or pinion. Length such as `"50 mm"`, above zero.
            mass: Moved mass. Mass such as `"3.2 kg"`, zero or more.
            inertia: Moment of inertia of the parts rotating with the output; if not stated, listed as assumed. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            inclination: Angle of the positive direction above the horizontal; 90 deg is upwards; default: horizontal, listed as assumed. Angle such as `"90 deg"`.
            counterweight: Counterweight; moves with the load and reduces it by its weight; on a hoist with as many falls as the load. Mass such as `"3.2 kg"`, zero or more.
            friction_force: Friction force of seals and guides. Force such as `"500 N"`, zero or more.
            friction_coefficient: Friction coefficient of the guide; default 0. 0 to 10.
            process_force: Process force along the guide, against the positive direction; does not change sign with the motion. Force such as `"500 N"`.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            pulley_diameter=pulley_diameter,
            mass=mass,
            inertia=inertia,
            inclination=inclination,
            counterweight=counterweight,
            friction_force=friction_force,
            friction_coefficient=friction_coefficient,
            process_force=process_force,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class Conveyor(Mechanism):
    """Conveyor belt or roller, running endlessly."""

    __slots__ = ()
    _TABLE = "mechanism.conveyor"
    _NEEDED = ("roller_diameter", "mass",)
    _KEYS = {
        "roller_diameter": Kind("quantity", example="50 mm"),
        "mass": Kind("quantity", example="3.2 kg"),
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "inclination": Kind("quantity", example="90 deg"),
        "friction_force": Kind("quantity", example="500 N"),
        "friction_coefficient": Kind("number", example="0.05"),
        "process_force": Kind("quantity", example="500 N"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    roller_diameter: str
    mass: str
    inertia: str | None
    inclination: str | None
    friction_force: str | None
    friction_coefficient: float | None
    process_force: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        roller_diameter: Quantity,
        mass: Quantity,
        inertia: Quantity | None = None,
        inclination: Quantity | None = None,
        friction_force: Quantity | None = None,
        friction_coefficient: float | None = None,
        process_force: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            roller_diameter: Diameter of the driving roller. Length such as `"50 mm"`, above zero.
            mass: Moved mass. Mass such as `"3.2 kg"`, zero or more.
            inertia: Moment of inertia of the parts rotating with the output; if not stated, listed as assumed. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            inclination: Angle of the positive direction above the horizontal; 90 deg is upwards; default: horizontal, listed as assumed. Angle such as `"90 deg"`.
            friction_force: Friction force of seals and guides. Force such as `"500 N"`, zero or more.
            friction_coefficient: Friction coefficient of the guide; default 0. 0 to 10.
            process_force: Process force along the guide, against the positive direction; does not change sign with the motion. Force such as `"500 N"`.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            roller_diameter=roller_diameter,
            mass=mass,
            inertia=inertia,
            inclination=inclination,
            friction_force=friction_force,
            friction_coefficient=friction_coefficient,
            process_force=process_force,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class SliderCrank(Mechanism):
    """Crank, rod and slider."""

    __slots__ = ()
    _TABLE = "mechanism.slider_crank"
    _NEEDED = ("crank", "rod", "mass",)
    _KEYS = {
        "crank": Kind("quantity", example="50 mm"),
        "rod": Kind("quantity", example="200 mm"),
        "mass": Kind("quantity", example="3.2 kg"),
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "inclination": Kind("quantity", example="90 deg"),
        "start_angle": Kind("quantity", example="90 deg"),
        "angle": Kind("alias", of_key="start_angle"),
        "process_force": Kind("quantity", example="500 N"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    crank: str
    rod: str
    mass: str
    inertia: str | None
    inclination: str | None
    start_angle: str | None
    process_force: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        crank: Quantity,
        rod: Quantity,
        mass: Quantity,
        inertia: Quantity | None = None,
        inclination: Quantity | None = None,
        start_angle: Quantity | None = None,
        angle: Quantity | None = None,
        process_force: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            crank: Crank radius. Length such as `"50 mm"`, above zero.
            rod: Rod length, longer than the crank. Length such as `"200 mm"`, above zero.
            mass: Moved mass. Mass such as `"3.2 kg"`, zero or more.
            inertia: Moment of inertia of the parts rotating with the output; if not stated, listed as assumed. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            inclination: Angle of the positive direction above the horizontal; 90 deg is upwards; default: horizontal, listed as assumed. Angle such as `"90 deg"`.
            start_angle: Position at the beginning of the motion; default: zero, listed as assumed. Angle such as `"90 deg"`.
            angle: Another name of `start_angle`.
            process_force: Process force along the guide, against the positive direction; does not change sign with the motion. Force such as `"500 N"`.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            crank=crank,
            rod=rod,
            mass=mass,
            inertia=inertia,
            inclination=inclination,
            start_angle=start_angle,
            angle=angle,
            process_force=process_force,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class Joint(Mechanism):
    """Robot joint, torque recorded together with the motion."""

    __slots__ = ()
    _TABLE = "mechanism.joint"
    _KEYS = {
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "holding_torque": Kind("quantity", example="5 N m"),
    }

    inertia: str | None
    holding_torque: str | None

    def __init__(
        self,
        *,
        inertia: Quantity | None = None,
        holding_torque: Quantity | None = None,
    ) -> None:
        """Args:
            inertia: Largest moment of inertia at the joint, for inertia ratio, natural frequency and brake; already included in the recorded torque. Moment of inertia such as `"1.3 kg m^2"`, above zero.
            holding_torque: Largest holding torque of the arm at standstill, for the brake. Torque such as `"5 N m"`, zero or more.
        """
        self._begin(
            inertia=inertia,
            holding_torque=holding_torque,
        )


class TableMechanism(Mechanism):
    """Moment of inertia and torque as a function of position."""

    __slots__ = ()
    _TABLE = "mechanism.table"
    _NEEDED = ("points",)
    _KEYS = {
        "points": Kind("rows", example="[[\"0 deg\", \"1.3 kg m^2\", \"5 N m\"], [\"90 deg\", \"1.6 kg m^2\", \"0 N m\"]]", columns=3),
        "start_angle": Kind("quantity", example="90 deg"),
        "angle": Kind("alias", of_key="start_angle"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    points: tuple[tuple[str, ...], ...]
    start_angle: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        points: Sequence[tuple[Quantity, Quantity, Quantity]],
        start_angle: Quantity | None = None,
        angle: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            points: Position, moment of inertia, holding torque; linear interpolation between the points.
            start_angle: Position at the beginning of the motion; default: zero, listed as assumed. Angle such as `"90 deg"`.
            angle: Another name of `start_angle`.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            points=points,
            start_angle=start_angle,
            angle=angle,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class Hoist(Mechanism):
    """Hoist: drum, rope and load."""

    __slots__ = ()
    _TABLE = "mechanism.hoist"
    _NEEDED = ("drum_diameter", "mass",)
    _KEYS = {
        "drum_diameter": Kind("quantity", example="320 mm"),
        "falls": Kind("integer", example="2"),
        "mass": Kind("quantity", example="3.2 kg"),
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "rope_mass": Kind("quantity", example="4 kg"),
        "hanging": Kind("quantity", example="6 m"),
        "sheave_efficiency": Kind("number", example="0.98"),
        "counterweight": Kind("quantity", example="3.2 kg"),
        "process_force": Kind("quantity", example="500 N"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    drum_diameter: str
    falls: int | None
    mass: str
    inertia: str | None
    rope_mass: str | None
    hanging: str | None
    sheave_efficiency: float | None
    counterweight: str | None
    process_force: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        drum_diameter: Quantity,
        falls: int | None = None,
        mass: Quantity,
        inertia: Quantity | None = None,
        rope_mass: Quantity | None = None,
        hanging: Quantity | None = None,
        sheave_efficiency: float | None = None,
        counterweight: Quantity | None = None,
        process_force: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            drum_diameter: Drum diameter to the rope centre. Length such as `"320 mm"`, above zero.
            falls: Number of rope falls carrying the load; default 1. 1 to 32.
            mass: Load with hook and lower block. Mass such as `"3.2 kg"`, zero or more.
            inertia: Moment of inertia of the drum and the parts rotating with it; if not stated, listed as assumed. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            rope_mass: Mass of all falls at position zero; default: neglected, listed as assumed. Mass such as `"4 kg"`, zero or more.
            hanging: Length of each fall at position zero. Length such as `"6 m"`, above zero.
            sheave_efficiency: Efficiency of one sheave; default 1, listed as assumed. 0.5 to 1.
            counterweight: Counterweight; moves with the load and reduces it by its weight; on a hoist with as many falls as the load. Mass such as `"3.2 kg"`, zero or more.
            process_force: Process force along the guide, against the positive direction; does not change sign with the motion. Force such as `"500 N"`.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            drum_diameter=drum_diameter,
            falls=falls,
            mass=mass,
            inertia=inertia,
            rope_mass=rope_mass,
            hanging=hanging,
            sheave_efficiency=sheave_efficiency,
            counterweight=counterweight,
            process_force=process_force,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class Winder(Mechanism):
    """Winder: roll with increasing or decreasing diameter."""

    __slots__ = ()
    _TABLE = "mechanism.winder"
    _NEEDED = ("core_diameter", "full_diameter", "thickness", "width", "density", "tension",)
    _KEYS = {
        "winding": Kind("word", words=("up", "off",)),
        "core_diameter": Kind("quantity", example="90 mm"),
        "full_diameter": Kind("quantity", example="400 mm"),
        "start_diameter": Kind("quantity", example="90 mm"),
        "thickness": Kind("quantity", example="0.2 mm"),
        "width": Kind("quantity", example="600 mm"),
        "density": Kind("quantity", example="900 kg/m^3"),
        "tension": Kind("quantity", example="120 N"),
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    winding: Literal["up", "off"] | None
    core_diameter: str
    full_diameter: str
    start_diameter: str | None
    thickness: str
    width: str
    density: str
    tension: str
    inertia: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        winding: Literal["up", "off"] | None = None,
        core_diameter: Quantity,
        full_diameter: Quantity,
        start_diameter: Quantity | None = None,
        thickness: Quantity,
        width: Quantity,
        density: Quantity,
        tension: Quantity,
        inertia: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            winding: Winding or unwinding of the web with positive rotation; default up, listed as assumed.
            core_diameter: Outer diameter of the core. Length such as `"90 mm"`, above zero.
            full_diameter: Diameter of the full roll. Length such as `"400 mm"`, above zero.
            start_diameter: Diameter at position zero; default: the core when winding, the full roll when unwinding, listed as assumed. Length such as `"90 mm"`, above zero.
            thickness: Thickness of the web; change of the radius per turn. Length such as `"0.2 mm"`, above zero.
            width: Width of the web. Length such as `"600 mm"`, above zero.
            density: Density of the wound material. Density such as `"900 kg/m^3"`, above zero.
            tension: Web tension, also at standstill. Force such as `"120 N"`, zero or more.
            inertia: Moment of inertia of core and shaft; if not stated, listed as assumed. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            winding=winding,
            core_diameter=core_diameter,
            full_diameter=full_diameter,
            start_diameter=start_diameter,
            thickness=thickness,
            width=width,
            density=density,
            tension=tension,
            inertia=inertia,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class ScissorLift(Mechanism):
    """Scissor lift with a screw."""

    __slots__ = ()
    _TABLE = "mechanism.scissor_lift"
    _NEEDED = ("arm_length", "lead", "arm_angle", "mass",)
    _KEYS = {
        "stages": Kind("integer", example="2"),
        "arm_length": Kind("quantity", example="1.2 m"),
        "lead": Kind("quantity", example="10 mm"),
        "arm_angle": Kind("quantity", example="20 deg"),
        "mass": Kind("quantity", example="3.2 kg"),
        "arm_mass": Kind("quantity", example="60 kg"),
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "process_force": Kind("quantity", example="500 N"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    stages: int | None
    arm_length: str
    lead: str
    arm_angle: str
    mass: str
    arm_mass: str | None
    inertia: str | None
    process_force: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        stages: int | None = None,
        arm_length: Quantity,
        lead: Quantity,
        arm_angle: Quantity,
        mass: Quantity,
        arm_mass: Quantity | None = None,
        inertia: Quantity | None = None,
        process_force: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            stages: Number of scissor stages; default: one; default 1, listed as assumed. 1 to 32.
            arm_length: Length of an arm between the pins at its ends. Length such as `"1.2 m"`, above zero.
            lead: Lead of the screw: travel of the nut per revolution towards the fixed pin. Lead such as `"10 mm"`, above zero.
            arm_angle: Angle of the arms above the horizontal at position zero. Angle such as `"20 deg"`.
            mass: Platform with its permanent load. Mass such as `"3.2 kg"`, zero or more.
            arm_mass: Total mass of all arms; default: neglected, listed as assumed. Mass such as `"60 kg"`, zero or more.
            inertia: Moment of inertia of screw and coupling; if not stated, listed as assumed. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            process_force: Process force along the guide, against the positive direction; does not change sign with the motion. Force such as `"500 N"`.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            stages=stages,
            arm_length=arm_length,
            lead=lead,
            arm_angle=arm_angle,
            mass=mass,
            arm_mass=arm_mass,
            inertia=inertia,
            process_force=process_force,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class FourBar(Mechanism):
    """Four-bar linkage: crank, coupler and rocker."""

    __slots__ = ()
    _TABLE = "mechanism.four_bar"
    _NEEDED = ("ground", "crank", "coupler", "rocker",)
    _KEYS = {
        "ground": Kind("quantity", example="400 mm"),
        "crank": Kind("quantity", example="100 mm"),
        "coupler": Kind("quantity", example="350 mm"),
        "rocker": Kind("quantity", example="250 mm"),
        "crossed": Kind("bool"),
        "inertia": Kind("quantity", example="1.3 kg m^2"),
        "coupler_mass": Kind("quantity", example="3.2 kg"),
        "coupler_centre": Kind("quantity", example="175 mm"),
        "coupler_inertia": Kind("quantity", example="1.3 kg m^2"),
        "rocker_mass": Kind("quantity", example="3.2 kg"),
        "rocker_centre": Kind("quantity", example="125 mm"),
        "rocker_inertia": Kind("quantity", example="1.3 kg m^2"),
        "rocker_torque": Kind("quantity", example="5 N m"),
        "axis_tilt": Kind("quantity", example="90 deg"),
        "inclination": Kind("quantity", example="90 deg"),
        "start_angle": Kind("quantity", example="90 deg"),
        "angle": Kind("alias", of_key="start_angle"),
        "friction_torque": Kind("quantity", example="5 N m"),
        "viscous_friction": Kind("quantity", example="0.5 N m s/rad"),
        "external_torque": Kind("quantity", example="5 N m"),
        "efficiency": Kind("number", example="0.9"),
        "efficiency_back": Kind("number", example="0.8"),
    }

    ground: str
    crank: str
    coupler: str
    rocker: str
    crossed: bool | None
    inertia: str | None
    coupler_mass: str | None
    coupler_centre: str | None
    coupler_inertia: str | None
    rocker_mass: str | None
    rocker_centre: str | None
    rocker_inertia: str | None
    rocker_torque: str | None
    axis_tilt: str | None
    inclination: str | None
    start_angle: str | None
    friction_torque: str | None
    viscous_friction: str | None
    external_torque: str | None
    efficiency: float | None
    efficiency_back: float | None

    def __init__(
        self,
        *,
        ground: Quantity,
        crank: Quantity,
        coupler: Quantity,
        rocker: Quantity,
        crossed: bool | None = None,
        inertia: Quantity | None = None,
        coupler_mass: Quantity | None = None,
        coupler_centre: Quantity | None = None,
        coupler_inertia: Quantity | None = None,
        rocker_mass: Quantity | None = None,
        rocker_centre: Quantity | None = None,
        rocker_inertia: Quantity | None = None,
        rocker_torque: Quantity | None = None,
        axis_tilt: Quantity | None = None,
        inclination: Quantity | None = None,
        start_angle: Quantity | None = None,
        angle: Quantity | None = None,
        friction_torque: Quantity | None = None,
        viscous_friction: Quantity | None = None,
        external_torque: Quantity | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
    ) -> None:
        """Args:
            ground: Distance between the two fixed pivots. Length such as `"400 mm"`, above zero.
            crank: Length of the crank. Length such as `"100 mm"`, above zero.
            coupler: Length of the coupler. Length such as `"350 mm"`, above zero.
            rocker: Length of the rocker. Length such as `"250 mm"`, above zero.
            crossed: True: coupler and rocker crossed.
            inertia: Moment of inertia of the crank and the parts rotating with it; if not stated, listed as assumed. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            coupler_mass: Mass of the coupler; if not stated, listed as assumed. Mass such as `"3.2 kg"`, zero or more.
            coupler_centre: Distance of the coupler's centre of mass from the crank pin. Length such as `"175 mm"`, zero or more.
            coupler_inertia: Moment of inertia of the coupler about its centre of mass. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            rocker_mass: Mass of the rocker, for its weight; if not stated, listed as assumed. Mass such as `"3.2 kg"`, zero or more.
            rocker_centre: Distance of the rocker's centre of mass from its pivot. Length such as `"125 mm"`, zero or more.
            rocker_inertia: Moment of inertia of the rocker and its load about its pivot. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            rocker_torque: Torque on the rocker against its positive direction. Torque such as `"5 N m"`.
            axis_tilt: Tilt of the axes from the vertical; default: 90 deg, an upright linkage, listed as assumed. Angle such as `"90 deg"`.
            inclination: Angle of the fixed link above the horizontal, from crank to rocker; if not stated, listed as assumed. Angle such as `"90 deg"`.
            start_angle: Position at the beginning of the motion; default: zero, listed as assumed. Angle such as `"90 deg"`.
            angle: Another name of `start_angle`.
            friction_torque: T_L, friction torque at the output; opposes every motion; zero if no friction is stated, listed as assumed. Torque such as `"5 N m"`, zero or more.
            viscous_friction: Viscous friction at the output, proportional to the speed. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            external_torque: Constant torque at the output against the positive direction; does not change sign with the motion. Torque such as `"5 N m"`.
            efficiency: Efficiency while the actuator drives the load; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the load drives the actuator; default 1, listed as assumed. 0 to 1.
        """
        self._begin(
            ground=ground,
            crank=crank,
            coupler=coupler,
            rocker=rocker,
            crossed=crossed,
            inertia=inertia,
            coupler_mass=coupler_mass,
            coupler_centre=coupler_centre,
            coupler_inertia=coupler_inertia,
            rocker_mass=rocker_mass,
            rocker_centre=rocker_centre,
            rocker_inertia=rocker_inertia,
            rocker_torque=rocker_torque,
            axis_tilt=axis_tilt,
            inclination=inclination,
            start_angle=start_angle,
            angle=angle,
            friction_torque=friction_torque,
            viscous_friction=viscous_friction,
            external_torque=external_torque,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
        )


class Columns(Section):
    """Names of its columns, if they differ from the default names."""

    __slots__ = ()
    _TABLE = "motion.columns"
    _KEYS = {
        "time": Kind("text"),
        "position": Kind("text"),
        "speed": Kind("text"),
        "torque": Kind("text"),
    }

    time: str | None
    position: str | None
    speed: str | None
    torque: str | None

    def __init__(
        self,
        *,
        time: str | None = None,
        position: str | None = None,
        speed: str | None = None,
        torque: str | None = None,
    ) -> None:
        """Args:
            time: Name of the time column.
            position: Name of the position column; none: not present.
            speed: Name of the speed column; none: not present.
            torque: Name of the torque or force column; none: not present.
        """
        self._begin(
            time=time,
            position=position,
            speed=speed,
            torque=torque,
        )


class Units(Section):
    """Units of its columns, if not stated in the file."""

    __slots__ = ()
    _TABLE = "motion.units"
    _KEYS = {
        "time": Kind("text"),
        "position": Kind("text"),
        "speed": Kind("text"),
        "torque": Kind("text"),
    }

    time: str | None
    position: str | None
    speed: str | None
    torque: str | None

    def __init__(
        self,
        *,
        time: str | None = None,
        position: str | None = None,
        speed: str | None = None,
        torque: str | None = None,
    ) -> None:
        """Args:
            time: Unit of time, if not stated in the file.
            position: Unit of position, if not stated in the file.
            speed: Unit of speed, if not stated in the file.
            torque: Unit of torque or force, if not stated in the file.
        """
        self._begin(
            time=time,
            position=position,
            speed=speed,
            torque=torque,
        )


class RecordedRatio(Section):
    """Ratio of the recorded gear, for quantities recorded at the motor."""

    __slots__ = ()
    _TABLE = "motion.recorded_ratio"
    _KEYS = {
        "position": Kind("number", example="80"),
        "speed": Kind("number", example="80"),
        "torque": Kind("number", example="80"),
    }

    position: float | None
    speed: float | None
    torque: float | None

    def __init__(
        self,
        *,
        position: float | None = None,
        speed: float | None = None,
        torque: float | None = None,
    ) -> None:
        """Args:
            position: Turns at the place of recording per turn of the output, negative where it turns the other way; 1: recorded at the output. -10000000000 to 10000000000.
            speed: Speed at the place of recording per speed of the output, negative where it turns the other way; 1: recorded at the output. -10000000000 to 10000000000.
            torque: Ratio by which the recorded torque is multiplied, negative where it acts the other way; 1: recorded at the output. -10000 to 10000.
        """
        self._begin(
            position=position,
            speed=speed,
            torque=torque,
        )


class FlangeLoads(Section):
    """Loads on the output flange in this segment; they replace all loads of [bearing], those not stated here are zero."""

    __slots__ = ()
    _TABLE = "motion.bearing"
    _KEYS = {
        "radial_force": Kind("quantity", example="500 N"),
        "radial_distance": Kind("quantity", example="50 mm"),
        "axial_force": Kind("quantity", example="500 N"),
        "axial_distance": Kind("quantity", example="50 mm"),
    }

    radial_force: str | None
    radial_distance: str | None
    axial_force: str | None
    axial_distance: str | None

    def __init__(
        self,
        *,
        radial_force: Quantity | None = None,
        radial_distance: Quantity | None = None,
        axial_force: Quantity | None = None,
        axial_distance: Quantity | None = None,
    ) -> None:
        """Args:
            radial_force: F_r, radial force on the flange. Force such as `"500 N"`, zero or more.
            radial_distance: L_r, distance of the radial force from the flange face. Length such as `"50 mm"`, zero or more.
            axial_force: F_a, axial force on the flange. Force such as `"500 N"`, zero or more.
            axial_distance: L_a, distance of the axial force from the axis. Length such as `"50 mm"`, zero or more.
        """
        self._begin(
            radial_force=radial_force,
            radial_distance=radial_distance,
            axial_force=axial_force,
            axial_distance=axial_distance,
        )


class Move(Segment):
    """A move by a law of motion."""

    __slots__ = ()
    _TABLE = "motion"
    _PLACES = ("law",)
    _NEEDED = ("law",)
    _KEYS = {
        "law": Kind("word", words=("trapezoid", "triangle", "jerk", "polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine", "inclined_sine", "parabola", "constant", "open",)),
        "speed": Kind("quantity", example="40 1/min", other="0.5 m/s"),
        "distance": Kind("quantity", example="90 deg", other="50 mm"),
        "time": Kind("quantity", example="0.1 s"),
        "acceleration": Kind("quantity", example="42 rad/s^2", other="9.81 m/s^2"),
        "jerk": Kind("quantity", example="900 rad/s^3", other="50 m/s^3"),
        "end_speed": Kind("quantity", example="40 1/min", other="0.5 m/s"),
        "payload": Kind("quantity", example="3.2 kg"),
        "payload_inertia": Kind("quantity", example="1.3 kg m^2"),
        "process_force": Kind("quantity", example="500 N"),
        "process_torque": Kind("quantity", example="5 N m"),
        "bearing": Kind("table", table="FlangeLoads"),
    }

    law: Literal["trapezoid", "triangle", "jerk", "polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine", "inclined_sine", "parabola", "constant", "open"]
    speed: str | None
    distance: str | None
    time: str | None
    acceleration: str | None
    jerk: str | None
    end_speed: str | None
    payload: str | None
    payload_inertia: str | None
    process_force: str | None
    process_torque: str | None
    bearing: FlangeLoads | None

    def __init__(
        self,
        law: Literal["trapezoid", "triangle", "jerk", "polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine", "inclined_sine", "parabola", "constant", "open"],
        *,
        speed: Quantity | None = None,
        distance: Quantity | None = None,
        time: Quantity | None = None,
        acceleration: Quantity | None = None,
        jerk: Quantity | None = None,
        end_speed: Quantity | None = None,
        payload: Quantity | None = None,
        payload_inertia: Quantity | None = None,
        process_force: Quantity | None = None,
        process_torque: Quantity | None = None,
        bearing: FlangeLoads | None = None,
    ) -> None:
        """Args:
            law: Motion law.
            speed: Maximum speed; at the output or along the guide, negative for the return move. Rotational speed or Velocity such as `"40 1/min"`.
            distance: Travel; negative for the reverse direction. Angle or Length such as `"90 deg"`.
            time: Duration of the segment. Time such as `"0.1 s"`, zero or more.
            acceleration: Maximum acceleration and deceleration. Angular acceleration or Acceleration such as `"42 rad/s^2"`, above zero.
            jerk: Maximum jerk. Angular jerk or Jerk such as `"900 rad/s^3"`, above zero.
            end_speed: Speed at the end of the segment; default: standstill. Rotational speed or Velocity such as `"40 1/min"`.
            payload: Payload in this segment; added to the masses of the mechanism. Mass such as `"3.2 kg"`, zero or more.
            payload_inertia: Moment of inertia of the payload at the output in this segment; added to that of the mechanism. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            process_force: Additional process force in this segment; along the guide, against the positive direction, added to the process force of the mechanism. Force such as `"500 N"`.
            process_torque: Additional process torque in this segment; at the output, against the positive direction, added to external_torque. Torque such as `"5 N m"`.
            bearing: Loads on the output flange in this segment; they replace all loads of [bearing], those not stated here are zero.
        """
        self._begin(
            law=law,
            speed=speed,
            distance=distance,
            time=time,
            acceleration=acceleration,
            jerk=jerk,
            end_speed=end_speed,
            payload=payload,
            payload_inertia=payload_inertia,
            process_force=process_force,
            process_torque=process_torque,
            bearing=bearing,
        )


class Return(ReturnMove):
    """A move back to where the motion began: its distance is that of all moves before it, its law that of the last."""

    __slots__ = ()
    _TABLE = "motion"
    _KEYS = {
        "law": Kind("word", words=("trapezoid", "triangle", "jerk", "polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine", "inclined_sine", "parabola", "constant", "open",)),
        "speed": Kind("quantity", example="40 1/min", other="0.5 m/s"),
        "time": Kind("quantity", example="0.1 s"),
        "acceleration": Kind("quantity", example="42 rad/s^2", other="9.81 m/s^2"),
        "jerk": Kind("quantity", example="900 rad/s^3", other="50 m/s^3"),
        "end_speed": Kind("quantity", example="40 1/min", other="0.5 m/s"),
        "payload": Kind("quantity", example="3.2 kg"),
        "payload_inertia": Kind("quantity", example="1.3 kg m^2"),
        "process_force": Kind("quantity", example="500 N"),
        "process_torque": Kind("quantity", example="5 N m"),
        "bearing": Kind("table", table="FlangeLoads"),
    }

    law: Literal["trapezoid", "triangle", "jerk", "polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine", "inclined_sine", "parabola", "constant", "open"] | None
    speed: str | None
    time: str | None
    acceleration: str | None
    jerk: str | None
    end_speed: str | None
    payload: str | None
    payload_inertia: str | None
    process_force: str | None
    process_torque: str | None
    bearing: FlangeLoads | None

    def __init__(
        self,
        *,
        law: Literal["trapezoid", "triangle", "jerk", "polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine", "inclined_sine", "parabola", "constant", "open"] | None = None,
        speed: Quantity | None = None,
        time: Quantity | None = None,
        acceleration: Quantity | None = None,
        jerk: Quantity | None = None,
        end_speed: Quantity | None = None,
        payload: Quantity | None = None,
        payload_inertia: Quantity | None = None,
        process_force: Quantity | None = None,
        process_torque: Quantity | None = None,
        bearing: FlangeLoads | None = None,
    ) -> None:
        """Args:
            law: Motion law.
            speed: Maximum speed; at the output or along the guide, negative for the return move. Rotational speed or Velocity such as `"40 1/min"`.
            time: Duration of the segment. Time such as `"0.1 s"`, zero or more.
            acceleration: Maximum acceleration and deceleration. Angular acceleration or Acceleration such as `"42 rad/s^2"`, above zero.
            jerk: Maximum jerk. Angular jerk or Jerk such as `"900 rad/s^3"`, above zero.
            end_speed: Speed at the end of the segment; default: standstill. Rotational speed or Velocity such as `"40 1/min"`.
            payload: Payload in this segment; added to the masses of the mechanism. Mass such as `"3.2 kg"`, zero or more.
            payload_inertia: Moment of inertia of the payload at the output in this segment; added to that of the mechanism. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            process_force: Additional process force in this segment; along the guide, against the positive direction, added to the process force of the mechanism. Force such as `"500 N"`.
            process_torque: Additional process torque in this segment; at the output, against the positive direction, added to external_torque. Torque such as `"5 N m"`.
            bearing: Loads on the output flange in this segment; they replace all loads of [bearing], those not stated here are zero.
        """
        self._begin(
            law=law,
            speed=speed,
            time=time,
            acceleration=acceleration,
            jerk=jerk,
            end_speed=end_speed,
            payload=payload,
            payload_inertia=payload_inertia,
            process_force=process_force,
            process_torque=process_torque,
            bearing=bearing,
        )


class Manual(Segment):
    """A segment by the law `manual`: trapezoid."""

    __slots__ = ()
    _TABLE = "motion"
    _LAW = "manual"
    _PLACES = ("speed",)
    _NEEDED = ("speed", "accelerate", "run", "brake", "pause",)
    _KEYS = {
        "speed": Kind("quantity", example="40 1/min", other="0.5 m/s"),
        "accelerate": Kind("quantity", example="0.1 s"),
        "run": Kind("quantity", example="0.1 s"),
        "brake": Kind("quantity", example="0.1 s"),
        "pause": Kind("quantity", example="0.1 s"),
        "payload": Kind("quantity", example="3.2 kg"),
        "payload_inertia": Kind("quantity", example="1.3 kg m^2"),
        "process_force": Kind("quantity", example="500 N"),
        "process_torque": Kind("quantity", example="5 N m"),
        "bearing": Kind("table", table="FlangeLoads"),
    }

    speed: str
    accelerate: str
    run: str
    brake: str
    pause: str
    payload: str | None
    payload_inertia: str | None
    process_force: str | None
    process_torque: str | None
    bearing: FlangeLoads | None

    def __init__(
        self,
        speed: Quantity,
        *,
        accelerate: Quantity,
        run: Quantity,
        brake: Quantity,
        pause: Quantity,
        payload: Quantity | None = None,
        payload_inertia: Quantity | None = None,
        process_force: Quantity | None = None,
        process_torque: Quantity | None = None,
        bearing: FlangeLoads | None = None,
    ) -> None:
        """Args:
            speed: Maximum speed; at the output or along the guide, negative for the return move. Rotational speed or Velocity such as `"40 1/min"`.
            accelerate: T_1, acceleration time from standstill. Time such as `"0.1 s"`, zero or more.
            run: T_2, time at constant speed. Time such as `"0.1 s"`, zero or more.
            brake: T_3, braking time to standstill. Time such as `"0.1 s"`, zero or more.
            pause: T_p, pause after the move. Time such as `"0.1 s"`, zero or more.
            payload: Payload in this segment; added to the masses of the mechanism. Mass such as `"3.2 kg"`, zero or more.
            payload_inertia: Moment of inertia of the payload at the output in this segment; added to that of the mechanism. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            process_force: Additional process force in this segment; along the guide, against the positive direction, added to the process force of the mechanism. Force such as `"500 N"`.
            process_torque: Additional process torque in this segment; at the output, against the positive direction, added to external_torque. Torque such as `"5 N m"`.
            bearing: Loads on the output flange in this segment; they replace all loads of [bearing], those not stated here are zero.
        """
        self._begin(
            speed=speed,
            accelerate=accelerate,
            run=run,
            brake=brake,
            pause=pause,
            payload=payload,
            payload_inertia=payload_inertia,
            process_force=process_force,
            process_torque=process_torque,
            bearing=bearing,
        )


class Dwell(Segment):
    """A segment by the law `dwell`: dwell."""

    __slots__ = ()
    _TABLE = "motion"
    _LAW = "dwell"
    _PLACES = ("time",)
    _KEYS = {
        "time": Kind("quantity", example="0.1 s"),
        "cycle": Kind("quantity", example="2 s"),
        "hold": Kind("word", words=("motor", "brake", "free",)),
        "payload": Kind("quantity", example="3.2 kg"),
        "payload_inertia": Kind("quantity", example="1.3 kg m^2"),
        "process_force": Kind("quantity", example="500 N"),
        "process_torque": Kind("quantity", example="5 N m"),
        "bearing": Kind("table", table="FlangeLoads"),
    }

    time: str | None
    cycle: str | None
    hold: Literal["motor", "brake", "free"] | None
    payload: str | None
    payload_inertia: str | None
    process_force: str | None
    process_torque: str | None
    bearing: FlangeLoads | None

    def __init__(
        self,
        time: Quantity | None = None,
        *,
        cycle: Quantity | None = None,
        hold: Literal["motor", "brake", "free"] | None = None,
        payload: Quantity | None = None,
        payload_inertia: Quantity | None = None,
        process_force: Quantity | None = None,
        process_torque: Quantity | None = None,
        bearing: FlangeLoads | None = None,
    ) -> None:
        """Args:
            time: Duration of the segment. Time such as `"0.1 s"`, zero or more.
            cycle: Cycle time up to which this dwell lasts, in place of its duration. Time such as `"2 s"`, above zero.
            hold: Means of holding the load at standstill; default motor, listed as assumed.
            payload: Payload in this segment; added to the masses of the mechanism. Mass such as `"3.2 kg"`, zero or more.
            payload_inertia: Moment of inertia of the payload at the output in this segment; added to that of the mechanism. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            process_force: Additional process force in this segment; along the guide, against the positive direction, added to the process force of the mechanism. Force such as `"500 N"`.
            process_torque: Additional process torque in this segment; at the output, against the positive direction, added to external_torque. Torque such as `"5 N m"`.
            bearing: Loads on the output flange in this segment; they replace all loads of [bearing], those not stated here are zero.
        """
        self._begin(
            time=time,
            cycle=cycle,
            hold=hold,
            payload=payload,
            payload_inertia=payload_inertia,
            process_force=process_force,
            process_torque=process_torque,
            bearing=bearing,
        )


class Recorded(Segment):
    """A segment by the law `recorded`: recording."""

    __slots__ = ()
    _TABLE = "motion"
    _LAW = "recorded"
    _PLACES = ("file",)
    _NEEDED = ("file",)
    _KEYS = {
        "file": Kind("text"),
        "columns": Kind("table", table="Columns"),
        "units": Kind("table", table="Units"),
        "recorded_ratio": Kind("table", table="RecordedRatio"),
        "from_": Kind("quantity", example="0.1 s"),
        "to": Kind("quantity", example="0.1 s"),
        "smoothing": Kind("quantity", example="20 ms"),
        "standstill": Kind("quantity", example="0.1 1/min", other="0.5 m/s"),
        "gaps": Kind("word", words=("allow",)),
        "held_values": Kind("word", words=("interpolate",)),
        "time_stamps": Kind("word", words=("even",)),
        "payload": Kind("quantity", example="3.2 kg"),
        "payload_inertia": Kind("quantity", example="1.3 kg m^2"),
        "process_force": Kind("quantity", example="500 N"),
        "process_torque": Kind("quantity", example="5 N m"),
        "bearing": Kind("table", table="FlangeLoads"),
    }

    file: str
    columns: Columns | None
    units: Units | None
    recorded_ratio: RecordedRatio | None
    from_: str | None
    to: str | None
    smoothing: str | None
    standstill: str | None
    gaps: Literal["allow"] | None
    held_values: Literal["interpolate"] | None
    time_stamps: Literal["even"] | None
    payload: str | None
    payload_inertia: str | None
    process_force: str | None
    process_torque: str | None
    bearing: FlangeLoads | None

    def __init__(
        self,
        file: str,
        *,
        columns: Columns | None = None,
        units: Units | None = None,
        recorded_ratio: RecordedRatio | None = None,
        from_: Quantity | None = None,
        to: Quantity | None = None,
        smoothing: Quantity | None = None,
        standstill: Quantity | None = None,
        gaps: Literal["allow"] | None = None,
        held_values: Literal["interpolate"] | None = None,
        time_stamps: Literal["even"] | None = None,
        payload: Quantity | None = None,
        payload_inertia: Quantity | None = None,
        process_force: Quantity | None = None,
        process_torque: Quantity | None = None,
        bearing: FlangeLoads | None = None,
    ) -> None:
        """Args:
            file: CSV or Parquet file with the recording, beside the project file.
            columns: Names of its columns, if they differ from the default names.
            units: Units of its columns, if not stated in the file.
            recorded_ratio: Ratio of the recorded gear, for quantities recorded at the motor.
            from_: Start of the window in the time of the file; earlier samples are omitted. Time such as `"0.1 s"`.
            to: End of the window in the time of the file; later samples are omitted. Time such as `"0.1 s"`.
            smoothing: Window width of a moving parabola; default: no smoothing. Time such as `"20 ms"`, above zero.
            standstill: Speeds below this value are treated as standstill. Rotational speed or Velocity such as `"0.1 1/min"`, above zero.
            gaps: Allow: long gaps between samples are intended.
            held_values: Interpolate: of values held over several rows one for each update is used; default: every row as it stands.
            time_stamps: Even: the rows are evenly spaced, their time stamps scatter about it; default: the time stamps as they stand.
            payload: Payload in this segment; added to the masses of the mechanism. Mass such as `"3.2 kg"`, zero or more.
            payload_inertia: Moment of inertia of the payload at the output in this segment; added to that of the mechanism. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            process_force: Additional process force in this segment; along the guide, against the positive direction, added to the process force of the mechanism. Force such as `"500 N"`.
            process_torque: Additional process torque in this segment; at the output, against the positive direction, added to external_torque. Torque such as `"5 N m"`.
            bearing: Loads on the output flange in this segment; they replace all loads of [bearing], those not stated here are zero.
        """
        self._begin(
            file=file,
            columns=columns,
            units=units,
            recorded_ratio=recorded_ratio,
            from_=from_,
            to=to,
            smoothing=smoothing,
            standstill=standstill,
            gaps=gaps,
            held_values=held_values,
            time_stamps=time_stamps,
            payload=payload,
            payload_inertia=payload_inertia,
            process_force=process_force,
            process_torque=process_torque,
            bearing=bearing,
        )


class Points(Segment):
    """A segment by the law `points`: cam table."""

    __slots__ = ()
    _TABLE = "motion"
    _LAW = "points"
    _PLACES = ("points",)
    _NEEDED = ("points", "spline", "ends",)
    _KEYS = {
        "end_speed": Kind("quantity", example="40 1/min", other="0.5 m/s"),
        "payload": Kind("quantity", example="3.2 kg"),
        "payload_inertia": Kind("quantity", example="1.3 kg m^2"),
        "process_force": Kind("quantity", example="500 N"),
        "process_torque": Kind("quantity", example="5 N m"),
        "bearing": Kind("table", table="FlangeLoads"),
        "points": Kind("rows", example="[[\"0 s\", \"0 deg\"], [\"0.2 s\", \"30 deg\"], [\"0.5 s\", \"90 deg\"]]", columns=2),
        "master_speed": Kind("quantity", example="40 1/min"),
        "spline": Kind("word", words=("cubic", "quintic",)),
        "ends": Kind("word", words=("rest", "natural", "periodic", "stated",)),
        "start_speed": Kind("quantity", example="40 1/min", other="0.5 m/s"),
        "start_acceleration": Kind("quantity", example="42 rad/s^2", other="9.81 m/s^2"),
        "end_acceleration": Kind("quantity", example="42 rad/s^2", other="9.81 m/s^2"),
    }

    end_speed: str | None
    payload: str | None
    payload_inertia: str | None
    process_force: str | None
    process_torque: str | None
    bearing: FlangeLoads | None
    points: tuple[tuple[str, ...], ...]
    master_speed: str | None
    spline: Literal["cubic", "quintic"]
    ends: Literal["rest", "natural", "periodic", "stated"]
    start_speed: str | None
    start_acceleration: str | None
    end_acceleration: str | None

    def __init__(
        self,
        points: Sequence[tuple[Quantity, Quantity]],
        *,
        end_speed: Quantity | None = None,
        payload: Quantity | None = None,
        payload_inertia: Quantity | None = None,
        process_force: Quantity | None = None,
        process_torque: Quantity | None = None,
        bearing: FlangeLoads | None = None,
        master_speed: Quantity | None = None,
        spline: Literal["cubic", "quintic"],
        ends: Literal["rest", "natural", "periodic", "stated"],
        start_speed: Quantity | None = None,
        start_acceleration: Quantity | None = None,
        end_acceleration: Quantity | None = None,
    ) -> None:
        """Args:
            end_speed: Speed at the end of the segment; default: standstill. Rotational speed or Velocity such as `"40 1/min"`.
            payload: Payload in this segment; added to the masses of the mechanism. Mass such as `"3.2 kg"`, zero or more.
            payload_inertia: Moment of inertia of the payload at the output in this segment; added to that of the mechanism. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            process_force: Additional process force in this segment; along the guide, against the positive direction, added to the process force of the mechanism. Force such as `"500 N"`.
            process_torque: Additional process torque in this segment; at the output, against the positive direction, added to external_torque. Torque such as `"5 N m"`.
            bearing: Loads on the output flange in this segment; they replace all loads of [bearing], those not stated here are zero.
            points: Points of a cam table: time or master angle, position; relative to the current position of the axis.
            master_speed: Constant speed of the master, if the points are stated over its angle. Rotational speed such as `"40 1/min"`, above zero.
            spline: Spline between the points: third degree, continuous acceleration; fifth degree, continuous jerk.
            ends: Boundary conditions at the first and last point: standstill, unconstrained (natural), equal at both (periodic), or as stated.
            start_speed: Speed at the first point. Rotational speed or Velocity such as `"40 1/min"`.
            start_acceleration: Acceleration at the first point, for the fifth degree. Angular acceleration or Acceleration such as `"42 rad/s^2"`.
            end_acceleration: Acceleration at the last point, for the fifth degree. Angular acceleration or Acceleration such as `"42 rad/s^2"`.
        """
        self._begin(
            end_speed=end_speed,
            payload=payload,
            payload_inertia=payload_inertia,
            process_force=process_force,
            process_torque=process_torque,
            bearing=bearing,
            points=points,
            master_speed=master_speed,
            spline=spline,
            ends=ends,
            start_speed=start_speed,
            start_acceleration=start_acceleration,
            end_acceleration=end_acceleration,
        )


class Web(Segment):
    """A segment by the law `web`: web run."""

    __slots__ = ()
    _TABLE = "motion"
    _LAW = "web"
    _PLACES = ("speed",)
    _NEEDED = ("speed",)
    _KEYS = {
        "speed": Kind("quantity", example="40 1/min", other="0.5 m/s"),
        "accelerate": Kind("quantity", example="0.1 s"),
        "brake": Kind("quantity", example="0.1 s"),
        "payload": Kind("quantity", example="3.2 kg"),
        "payload_inertia": Kind("quantity", example="1.3 kg m^2"),
        "process_force": Kind("quantity", example="500 N"),
        "process_torque": Kind("quantity", example="5 N m"),
        "bearing": Kind("table", table="FlangeLoads"),
    }

    speed: str
    accelerate: str | None
    brake: str | None
    payload: str | None
    payload_inertia: str | None
    process_force: str | None
    process_torque: str | None
    bearing: FlangeLoads | None

    def __init__(
        self,
        speed: Quantity,
        *,
        accelerate: Quantity | None = None,
        brake: Quantity | None = None,
        payload: Quantity | None = None,
        payload_inertia: Quantity | None = None,
        process_force: Quantity | None = None,
        process_torque: Quantity | None = None,
        bearing: FlangeLoads | None = None,
    ) -> None:
        """Args:
            speed: Maximum speed; at the output or along the guide, negative for the return move. Rotational speed or Velocity such as `"40 1/min"`.
            accelerate: T_1, acceleration time from standstill. Time such as `"0.1 s"`, zero or more.
            brake: T_3, braking time to standstill. Time such as `"0.1 s"`, zero or more.
            payload: Payload in this segment; added to the masses of the mechanism. Mass such as `"3.2 kg"`, zero or more.
            payload_inertia: Moment of inertia of the payload at the output in this segment; added to that of the mechanism. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            process_force: Additional process force in this segment; along the guide, against the positive direction, added to the process force of the mechanism. Force such as `"500 N"`.
            process_torque: Additional process torque in this segment; at the output, against the positive direction, added to external_torque. Torque such as `"5 N m"`.
            bearing: Loads on the output flange in this segment; they replace all loads of [bearing], those not stated here are zero.
        """
        self._begin(
            speed=speed,
            accelerate=accelerate,
            brake=brake,
            payload=payload,
            payload_inertia=payload_inertia,
            process_force=process_force,
            process_torque=process_torque,
            bearing=bearing,
        )


class Stage(Section):
    """Belt, gear or coupling between actuator and mechanism."""

    __slots__ = ()
    _TABLE = "stage"
    _NEEDED = ("kind",)
    _KEYS = {
        "kind": Kind("word", words=("belt", "gear", "coupling",)),
        "ratio": Kind("number", example="2.5"),
        "ratios": Kind("numbers", example="[1.0, 2.5]"),
        "efficiency": Kind("number", example="0.95"),
        "efficiency_back": Kind("number", example="0.9"),
        "inertia_driving": Kind("quantity", example="1.3 kg m^2"),
        "inertia_driven": Kind("quantity", example="1.3 kg m^2"),
        "stiffness": Kind("quantity", example="67000 N m/rad"),
        "backlash": Kind("quantity", example="3 arcmin"),
        "pitch_diameter": Kind("quantity", example="50 mm"),
    }

    kind: Literal["belt", "gear", "coupling"]
    ratio: float | None
    ratios: tuple[float, ...] | None
    efficiency: float | None
    efficiency_back: float | None
    inertia_driving: str | None
    inertia_driven: str | None
    stiffness: str | None
    backlash: str | None
    pitch_diameter: str | None

    def __init__(
        self,
        *,
        kind: Literal["belt", "gear", "coupling"],
        ratio: float | None = None,
        ratios: Sequence[float] | None = None,
        efficiency: float | None = None,
        efficiency_back: float | None = None,
        inertia_driving: Quantity | None = None,
        inertia_driven: Quantity | None = None,
        stiffness: Quantity | None = None,
        backlash: Quantity | None = None,
        pitch_diameter: Quantity | None = None,
    ) -> None:
        """Args:
            kind: Type of the stage.
            ratio: I_s, turns of the actuator output per turn of the mechanism; default for a coupling: 1. 0.01 to 1000.
            ratios: Several ratios from which the best is selected.
            efficiency: Efficiency while the actuator drives; default 1, listed as assumed. 0.01 to 1.
            efficiency_back: Efficiency while the mechanism drives; default 1, listed as assumed. 0 to 1.
            inertia_driving: J_1, moment of inertia of the parts rotating with the actuator. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            inertia_driven: J_2, moment of inertia of the parts rotating with the mechanism; zero if neither J_1 nor J_2 is stated, listed as assumed. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            stiffness: K_s, torsional stiffness of the stage on the mechanism side; default: rigid, listed as assumed. Torsional stiffness such as `"67000 N m/rad"`, above zero.
            backlash: Backlash on the mechanism side; default: none, listed as assumed. Angle such as `"3 arcmin"`, zero or more.
            pitch_diameter: Pitch diameter of the pulley or gear wheel on the actuator. Length such as `"50 mm"`, above zero.
        """
        self._begin(
            kind=kind,
            ratio=ratio,
            ratios=ratios,
            efficiency=efficiency,
            efficiency_back=efficiency_back,
            inertia_driving=inertia_driving,
            inertia_driven=inertia_driven,
            stiffness=stiffness,
            backlash=backlash,
            pitch_diameter=pitch_diameter,
        )


class Bearing(Section):
    """Loads on the output flange."""

    __slots__ = ()
    _TABLE = "bearing"
    _KEYS = {
        "radial_force": Kind("quantity", example="500 N"),
        "radial_distance": Kind("quantity", example="50 mm"),
        "axial_force": Kind("quantity", example="500 N"),
        "axial_distance": Kind("quantity", example="50 mm"),
        "load_factor": Kind("number", example="1.2"),
        "operating_condition": Kind("word", words=("normal", "shock", "high_accuracy",)),
        "mechanism": Kind("word", words=("add", "replace", "ignore",)),
        "overhang": Kind("quantity", example="50 mm"),
        "payload_overhang": Kind("quantity", example="50 mm"),
        "flange_share": Kind("number", example="0.5"),
        "belt_tension": Kind("quantity", example="500 N"),
        "pressure_angle": Kind("quantity", example="20 deg"),
        "helix_angle": Kind("quantity", example="15 deg"),
        "wheel_mass": Kind("quantity", example="1.2 kg"),
        "axis_tilt": Kind("quantity", example="90 deg"),
    }

    radial_force: str | None
    radial_distance: str | None
    axial_force: str | None
    axial_distance: str | None
    load_factor: float | None
    operating_condition: Literal["normal", "shock", "high_accuracy"] | None
    mechanism: Literal["add", "replace", "ignore"] | None
    overhang: str | None
    payload_overhang: str | None
    flange_share: float | None
    belt_tension: str | None
    pressure_angle: str | None
    helix_angle: str | None
    wheel_mass: str | None
    axis_tilt: str | None

    def __init__(
        self,
        *,
        radial_force: Quantity | None = None,
        radial_distance: Quantity | None = None,
        axial_force: Quantity | None = None,
        axial_distance: Quantity | None = None,
        load_factor: float | None = None,
        operating_condition: Literal["normal", "shock", "high_accuracy"] | None = None,
        mechanism: Literal["add", "replace", "ignore"] | None = None,
        overhang: Quantity | None = None,
        payload_overhang: Quantity | None = None,
        flange_share: float | None = None,
        belt_tension: Quantity | None = None,
        pressure_angle: Quantity | None = None,
        helix_angle: Quantity | None = None,
        wheel_mass: Quantity | None = None,
        axis_tilt: Quantity | None = None,
    ) -> None:
        """Args:
            radial_force: F_r, radial force on the flange. Force such as `"500 N"`, zero or more.
            radial_distance: L_r, distance of the radial force from the flange face. Length such as `"50 mm"`, zero or more.
            axial_force: F_a, axial force on the flange. Force such as `"500 N"`, zero or more.
            axial_distance: L_a, distance of the axial force from the axis. Length such as `"50 mm"`, zero or more.
            load_factor: F_w, load factor of table 74.2; without it, the life of the output bearing is not checked. 1 to 3.
            operating_condition: Operating condition of table 76.3; without it, the static safety is shown but not checked.
            mechanism: Loads resulting from the mechanism: added to the stated ones, replaced by those of a segment, or ignored; required beside stated loads, default without these: added.
            overhang: L, distance of the centre of mass or of the wheel centre from the flange face; wheel: pulley, pinion or crank pin. Length such as `"50 mm"`.
            payload_overhang: Distance of the payload of a segment from the flange face. Length such as `"50 mm"`.
            flange_share: Share of the mechanism forces acting on the flange; other bearings carry the rest; required for a screw, otherwise default 1, listed as assumed. 0 to 1.
            belt_tension: F_v, static tension of each belt span. Force such as `"500 N"`, zero or more.
            pressure_angle: Pressure angle of pinion and rack in the normal section. Angle such as `"20 deg"`, above zero.
            helix_angle: Helix angle of the teeth; default: spur teeth, listed as assumed. Angle such as `"15 deg"`, zero or more.
            wheel_mass: Mass of the wheel on the flange: pulley, pinion or crank; default: massless, listed as assumed. Mass such as `"1.2 kg"`, zero or more.
            axis_tilt: Tilt of the rotation axis from the vertical, for the weight of the wheel and of the roll of a winder; winder, default: 90 deg, a horizontal axis, listed as assumed. Angle such as `"90 deg"`.
        """
        self._begin(
            radial_force=radial_force,
            radial_distance=radial_distance,
            axial_force=axial_force,
            axial_distance=axial_distance,
            load_factor=load_factor,
            operating_condition=operating_condition,
            mechanism=mechanism,
            overhang=overhang,
            payload_overhang=payload_overhang,
            flange_share=flange_share,
            belt_tension=belt_tension,
            pressure_angle=pressure_angle,
            helix_angle=helix_angle,
            wheel_mass=wheel_mass,
            axis_tilt=axis_tilt,
        )


class Drive(Section):
    """The drive that supplies the motor."""

    __slots__ = ()
    _TABLE = "drive"
    _KEYS = {
        "current_continuous": Kind("quantity", example="5 A"),
        "current_peak": Kind("quantity", example="10 A"),
        "peak_time": Kind("quantity", example="2 s"),
    }

    current_continuous: str | None
    current_peak: str | None
    peak_time: str | None

    def __init__(
        self,
        *,
        current_continuous: Quantity | None = None,
        current_peak: Quantity | None = None,
        peak_time: Quantity | None = None,
    ) -> None:
        """Args:
            current_continuous: Continuous current of the drive, rms per phase. Electric current such as `"5 A"`, above zero.
            current_peak: Peak current of the drive, rms per phase. Electric current such as `"10 A"`, above zero.
            peak_time: Longest permissible time above the continuous current; default: not limited. Time such as `"2 s"`, above zero.
        """
        self._begin(
            current_continuous=current_continuous,
            current_peak=current_peak,
            peak_time=peak_time,
        )


class Actuator(Section):
    """An actuator not contained in the catalogue."""

    __slots__ = ()
    _TABLE = "actuator"
    _NEEDED = ("name",)
    _KEYS = {
        "name": Kind("text"),
        "ratio": Kind("number", example="50"),
        "torque_max": Kind("quantity", example="5 N m"),
        "speed_max": Kind("quantity", example="40 1/min"),
        "speed_motor_max": Kind("quantity", example="6000 1/min"),
        "speed_motor_rated": Kind("quantity", example="3500 1/min"),
        "inertia_out": Kind("quantity", example="1.3 kg m^2"),
        "stall_torque": Kind("quantity", example="5 N m"),
        "stall_current": Kind("quantity", example="2.1 A"),
        "current_max": Kind("quantity", example="2.1 A"),
        "current_demagnetisation": Kind("quantity", example="2.1 A"),
        "no_load_starting_current": Kind("quantity", example="2.1 A"),
        "no_load_current_constant_30": Kind("quantity", example="4e-3 A/(1/min)"),
        "no_load_current_constant_80": Kind("quantity", example="4e-3 A/(1/min)"),
        "torque_constant_out": Kind("quantity", example="16.5 N m/A"),
        "torque_constant_motor": Kind("quantity", example="16.5 N m/A"),
        "voltage_constant_motor": Kind("quantity", example="23 V/1000 1/min"),
        "resistance_ll": Kind("quantity", example="5.9 ohm"),
        "winding_temperature_max": Kind("quantity", example="40 °C"),
        "inductance_ll": Kind("quantity", example="8 mH"),
        "pole_pairs": Kind("integer", example="5"),
        "mass": Kind("quantity", example="3.2 kg"),
        "length": Kind("quantity", example="120 mm"),
        "hollow_shaft": Kind("quantity", example="18 mm"),
        "dc_link_max": Kind("quantity", example="560 V"),
        "terminal_voltage_min": Kind("quantity", example="560 V"),
        "gear_torque_rated": Kind("quantity", example="5 N m"),
        "gear_torque_mean_max": Kind("quantity", example="5 N m"),
        "gear_torque_momentary_max": Kind("quantity", example="5 N m"),
        "gear_speed_max": Kind("quantity", example="8500 1/min"),
        "gear_speed_mean_max": Kind("quantity", example="3500 1/min"),
        "gear_life_rated": Kind("quantity", example="7000 h"),
        "gear_life_speed": Kind("quantity", example="2000 1/min"),
        "stiffness_1": Kind("quantity", example="67000 N m/rad"),
        "stiffness_2": Kind("quantity", example="67000 N m/rad"),
        "stiffness_3": Kind("quantity", example="67000 N m/rad"),
        "torque_1": Kind("quantity", example="5 N m"),
        "torque_2": Kind("quantity", example="5 N m"),
        "transmission_accuracy": Kind("quantity", example="1 arcmin"),
        "repeatability": Kind("quantity", example="0.1 arcmin"),
        "hysteresis_loss": Kind("quantity", example="1 arcmin"),
        "lost_motion": Kind("quantity", example="1 arcmin"),
        "feedback_resolution": Kind("quantity", example="1 arcsec"),
        "feedback_accuracy": Kind("quantity", example="20 arcsec"),
        "bearing_type": Kind("word", words=("crossed_roller", "four_point",)),
        "bearing_pitch_diameter": Kind("quantity", example="85 mm"),
        "bearing_offset": Kind("quantity", example="15 mm"),
        "bearing_dynamic": Kind("quantity", example="15 kN"),
        "bearing_static": Kind("quantity", example="24 kN"),
        "tilting_moment_max": Kind("quantity", example="5 N m"),
        "static_moment_max": Kind("quantity", example="5 N m"),
        "axial_force_max": Kind("quantity", example="5 kN"),
        "radial_force_max": Kind("quantity", example="4 kN"),
        "tilting_stiffness": Kind("quantity", example="70 N m/arcmin"),
        "brake_torque": Kind("quantity", example="5 N m"),
        "brake_closing_time": Kind("quantity", example="40 ms"),
        "brake_opening_time": Kind("quantity", example="60 ms"),
        "winding_time_constant": Kind("quantity", example="60 s"),
        "ambient_min": Kind("quantity", example="40 °C"),
        "ambient_max": Kind("quantity", example="40 °C"),
        "short_time_curve": Kind("rows", example="[[\"0 1/min\", \"32 N m\"], [\"40 1/min\", \"25 N m\"]]", columns=2),
        "continuous_curve": Kind("rows", example="[[\"0 1/min\", \"32 N m\"], [\"40 1/min\", \"25 N m\"]]", columns=2),
    }

    name: str
    ratio: float | None
    torque_max: str | None
    speed_max: str | None
    speed_motor_max: str | None
    speed_motor_rated: str | None
    inertia_out: str | None
    stall_torque: str | None
    stall_current: str | None
    current_max: str | None
    current_demagnetisation: str | None
    no_load_starting_current: str | None
    no_load_current_constant_30: str | None
    no_load_current_constant_80: str | None
    torque_constant_out: str | None
    torque_constant_motor: str | None
    voltage_constant_motor: str | None
    resistance_ll: str | None
    winding_temperature_max: str | None
    inductance_ll: str | None
    pole_pairs: int | None
    mass: str | None
    length: str | None
    hollow_shaft: str | None
    dc_link_max: str | None
    terminal_voltage_min: str | None
    gear_torque_rated: str | None
    gear_torque_mean_max: str | None
    gear_torque_momentary_max: str | None
    gear_speed_max: str | None
    gear_speed_mean_max: str | None
    gear_life_rated: str | None
    gear_life_speed: str | None
    stiffness_1: str | None
    stiffness_2: str | None
    stiffness_3: str | None
    torque_1: str | None
    torque_2: str | None
    transmission_accuracy: str | None
    repeatability: str | None
    hysteresis_loss: str | None
    lost_motion: str | None
    feedback_resolution: str | None
    feedback_accuracy: str | None
    bearing_type: Literal["crossed_roller", "four_point"] | None
    bearing_pitch_diameter: str | None
    bearing_offset: str | None
    bearing_dynamic: str | None
    bearing_static: str | None
    tilting_moment_max: str | None
    static_moment_max: str | None
    axial_force_max: str | None
    radial_force_max: str | None
    tilting_stiffness: str | None
    brake_torque: str | None
    brake_closing_time: str | None
    brake_opening_time: str | None
    winding_time_constant: str | None
    ambient_min: str | None
    ambient_max: str | None
    short_time_curve: tuple[tuple[str, ...], ...] | None
    continuous_curve: tuple[tuple[str, ...], ...] | None

    def __init__(
        self,
        *,
        name: str,
        ratio: float | None = None,
        torque_max: Quantity | None = None,
        speed_max: Quantity | None = None,
        speed_motor_max: Quantity | None = None,
        speed_motor_rated: Quantity | None = None,
        inertia_out: Quantity | None = None,
        stall_torque: Quantity | None = None,
        stall_current: Quantity | None = None,
        current_max: Quantity | None = None,
        current_demagnetisation: Quantity | None = None,
        no_load_starting_current: Quantity | None = None,
        no_load_current_constant_30: Quantity | None = None,
        no_load_current_constant_80: Quantity | None = None,
        torque_constant_out: Quantity | None = None,
        torque_constant_motor: Quantity | None = None,
        voltage_constant_motor: Quantity | None = None,
        resistance_ll: Quantity | None = None,
        winding_temperature_max: Quantity | None = None,
        inductance_ll: Quantity | None = None,
        pole_pairs: int | None = None,
        mass: Quantity | None = None,
        length: Quantity | None = None,
        hollow_shaft: Quantity | None = None,
        dc_link_max: Quantity | None = None,
        terminal_voltage_min: Quantity | None = None,
        gear_torque_rated: Quantity | None = None,
        gear_torque_mean_max: Quantity | None = None,
        gear_torque_momentary_max: Quantity | None = None,
        gear_speed_max: Quantity | None = None,
        gear_speed_mean_max: Quantity | None = None,
        gear_life_rated: Quantity | None = None,
        gear_life_speed: Quantity | None = None,
        stiffness_1: Quantity | None = None,
        stiffness_2: Quantity | None = None,
        stiffness_3: Quantity | None = None,
        torque_1: Quantity | None = None,
        torque_2: Quantity | None = None,
        transmission_accuracy: Quantity | None = None,
        repeatability: Quantity | None = None,
        hysteresis_loss: Quantity | None = None,
        lost_motion: Quantity | None = None,
        feedback_resolution: Quantity | None = None,
        feedback_accuracy: Quantity | None = None,
        bearing_type: Literal["crossed_roller", "four_point"] | None = None,
        bearing_pitch_diameter: Quantity | None = None,
        bearing_offset: Quantity | None = None,
        bearing_dynamic: Quantity | None = None,
        bearing_static: Quantity | None = None,
        tilting_moment_max: Quantity | None = None,
        static_moment_max: Quantity | None = None,
        axial_force_max: Quantity | None = None,
        radial_force_max: Quantity | None = None,
        tilting_stiffness: Quantity | None = None,
        brake_torque: Quantity | None = None,
        brake_closing_time: Quantity | None = None,
        brake_opening_time: Quantity | None = None,
        winding_time_constant: Quantity | None = None,
        ambient_min: Quantity | None = None,
        ambient_max: Quantity | None = None,
        short_time_curve: Sequence[tuple[Quantity, Quantity]] | None = None,
        continuous_curve: Sequence[tuple[Quantity, Quantity]] | None = None,
    ) -> None:
        """Args:
            name: Name of the actuator.
            ratio: I, reduction ratio. 1 to 10000.
            torque_max: T_max, maximum torque at the output. Torque such as `"5 N m"`, above zero.
            speed_max: N_max, maximum speed at the output. Rotational speed such as `"40 1/min"`, above zero.
            speed_motor_max: Maximum motor speed. Rotational speed such as `"6000 1/min"`, above zero.
            speed_motor_rated: N_N, rated motor speed. Rotational speed such as `"3500 1/min"`, above zero.
            inertia_out: J_out, own moment of inertia at the output. Moment of inertia such as `"1.3 kg m^2"`, zero or more.
            stall_torque: T_0, continuous stall torque at the output. Torque such as `"5 N m"`, above zero.
            stall_current: I_0, stall current, rms. Electric current such as `"2.1 A"`, above zero.
            current_max: I_max, maximum current, rms. Electric current such as `"2.1 A"`, above zero.
            current_demagnetisation: I_E, demagnetisation current, rms. Electric current such as `"2.1 A"`, above zero.
            no_load_starting_current: I_NLS, no-load starting current, rms. Electric current such as `"2.1 A"`, zero or more.
            no_load_current_constant_30: K_INL, no-load current constant at 30 °C, per output speed. No-load current constant such as `"4e-3 A/(1/min)"`, zero or more.
            no_load_current_constant_80: K_INL, no-load current constant at 80 °C, per output speed. No-load current constant such as `"4e-3 A/(1/min)"`, zero or more.
            torque_constant_out: K_Tout, torque constant at the output, per A rms. Torque constant such as `"16.5 N m/A"`, above zero.
            torque_constant_motor: K_TM, torque constant of the motor, per A rms. Torque constant such as `"16.5 N m/A"`, above zero.
            voltage_constant_motor: K_EM, voltage constant of the motor, line to line, rms. Voltage constant such as `"23 V/1000 1/min"`, above zero.
            resistance_ll: R_LL, resistance line to line at 20 °C. Resistance such as `"5.9 ohm"`, above zero.
            winding_temperature_max: Maximum winding temperature, at which the voltage is checked; default: the shutdown threshold of the catalogue. Temperature such as `"40 °C"`.
            inductance_ll: L_LL, inductance line to line. Inductance such as `"8 mH"`, above zero.
            pole_pairs: P, number of pole pairs. 1 to 100.
            mass: M, mass. Mass such as `"3.2 kg"`, above zero.
            length: L, length. Length such as `"120 mm"`, above zero.
            hollow_shaft: D_H, hollow shaft bore diameter. Length such as `"18 mm"`, zero or more.
            dc_link_max: U_DCmax, maximum steady DC link voltage. Voltage such as `"560 V"`, above zero.
            terminal_voltage_min: U_M, terminal voltage from which the performance data are valid. Voltage such as `"560 V"`, above zero.
            gear_torque_rated: T_N, rated torque of the gear, for its life. Torque such as `"5 N m"`, above zero.
            gear_torque_mean_max: T_A, limit of the mean torque of the gear. Torque such as `"5 N m"`, above zero.
            gear_torque_momentary_max: T_M, limit of the momentary peak torque of the gear, in a collision. Torque such as `"5 N m"`, above zero.
            gear_speed_max: Largest input speed of the gear. Rotational speed such as `"8500 1/min"`, above zero.
            gear_speed_mean_max: Limit of the mean input speed of the gear. Rotational speed such as `"3500 1/min"`, above zero.
            gear_life_rated: L_10 life of the gear at T_N and n_N. Time such as `"7000 h"`, above zero.
            gear_life_speed: N_N, input speed to which the life applies. Rotational speed such as `"2000 1/min"`, above zero.
            stiffness_1: K_1, torsional stiffness below T_1. Torsional stiffness such as `"67000 N m/rad"`, above zero.
            stiffness_2: K_2, torsional stiffness between T_1 and T_2. Torsional stiffness such as `"67000 N m/rad"`, above zero.
            stiffness_3: K_3, torsional stiffness above T_2. Torsional stiffness such as `"67000 N m/rad"`, above zero.
            torque_1: T_1, end of the first region of stiffness. Torque such as `"5 N m"`, above zero.
            torque_2: T_2, end of the second region of stiffness. Torque such as `"5 N m"`, above zero.
            transmission_accuracy: Transmission accuracy of the gear, at the output. Angle such as `"1 arcmin"`, zero or more.
            repeatability: Repeatability of the gear, in either direction. Angle such as `"0.1 arcmin"`, zero or more.
            hysteresis_loss: Hysteresis loss of the gear. Angle such as `"1 arcmin"`, zero or more.
            lost_motion: Lost motion of the gear. Angle such as `"1 arcmin"`, zero or more.
            feedback_resolution: Step of the position, at the output. Angle such as `"1 arcsec"`, above zero.
            feedback_accuracy: Largest deviation of the position in either direction, at the output. Angle such as `"20 arcsec"`, zero or more.
            bearing_type: Design of the output bearing.
            bearing_pitch_diameter: D_p, pitch circle diameter of the output bearing. Length such as `"85 mm"`, above zero.
            bearing_offset: R, distance of the bearing centre from the flange face. Length such as `"15 mm"`, zero or more.
            bearing_dynamic: C, dynamic load rating of the output bearing. Force such as `"15 kN"`, above zero.
            bearing_static: C_0, static load rating of the output bearing. Force such as `"24 kN"`, above zero.
            tilting_moment_max: Permissible tilting moment in motion. Torque such as `"5 N m"`, above zero.
            static_moment_max: Permissible tilting moment at standstill. Torque such as `"5 N m"`, above zero.
            axial_force_max: Permissible axial force in motion, without other loads. Force such as `"5 kN"`, above zero.
            radial_force_max: Permissible radial force in motion, without other loads. Force such as `"4 kN"`, above zero.
            tilting_stiffness: K_B, tilting stiffness of the output bearing. Tilting stiffness such as `"70 N m/arcmin"`, above zero.
            brake_torque: T_Br, holding torque of the brake, at the output. Torque such as `"5 N m"`, above zero.
            brake_closing_time: T_c, closing time of the brake. Time such as `"40 ms"`, above zero.
            brake_opening_time: T_o, opening time of the brake. Time such as `"60 ms"`, above zero.
            winding_time_constant: Τ_w, thermal time constant of the winding. Time such as `"60 s"`, above zero.
            ambient_min: Lowest permissible ambient temperature in operation. Temperature such as `"40 °C"`.
            ambient_max: Highest permissible ambient temperature in operation. Temperature such as `"40 °C"`.
            short_time_curve: Corner points of the short-time curve, from standstill.
            continuous_curve: Corner points of the continuous-duty curve, from standstill.
        """
        self._begin(
            name=name,
            ratio=ratio,
            torque_max=torque_max,
            speed_max=speed_max,
            speed_motor_max=speed_motor_max,
            speed_motor_rated=speed_motor_rated,
            inertia_out=inertia_out,
            stall_torque=stall_torque,
            stall_current=stall_current,
            current_max=current_max,
            current_demagnetisation=current_demagnetisation,
            no_load_starting_current=no_load_starting_current,
            no_load_current_constant_30=no_load_current_constant_30,
            no_load_current_constant_80=no_load_current_constant_80,
            torque_constant_out=torque_constant_out,
            torque_constant_motor=torque_constant_motor,
            voltage_constant_motor=voltage_constant_motor,
            resistance_ll=resistance_ll,
            winding_temperature_max=winding_temperature_max,
            inductance_ll=inductance_ll,
            pole_pairs=pole_pairs,
            mass=mass,
            length=length,
            hollow_shaft=hollow_shaft,
            dc_link_max=dc_link_max,
            terminal_voltage_min=terminal_voltage_min,
            gear_torque_rated=gear_torque_rated,
            gear_torque_mean_max=gear_torque_mean_max,
            gear_torque_momentary_max=gear_torque_momentary_max,
            gear_speed_max=gear_speed_max,
            gear_speed_mean_max=gear_speed_mean_max,
            gear_life_rated=gear_life_rated,
            gear_life_speed=gear_life_speed,
            stiffness_1=stiffness_1,
            stiffness_2=stiffness_2,
            stiffness_3=stiffness_3,
            torque_1=torque_1,
            torque_2=torque_2,
            transmission_accuracy=transmission_accuracy,
            repeatability=repeatability,
            hysteresis_loss=hysteresis_loss,
            lost_motion=lost_motion,
            feedback_resolution=feedback_resolution,
            feedback_accuracy=feedback_accuracy,
            bearing_type=bearing_type,
            bearing_pitch_diameter=bearing_pitch_diameter,
            bearing_offset=bearing_offset,
            bearing_dynamic=bearing_dynamic,
            bearing_static=bearing_static,
            tilting_moment_max=tilting_moment_max,
            static_moment_max=static_moment_max,
            axial_force_max=axial_force_max,
            radial_force_max=radial_force_max,
            tilting_stiffness=tilting_stiffness,
            brake_torque=brake_torque,
            brake_closing_time=brake_closing_time,
            brake_opening_time=brake_opening_time,
            winding_time_constant=winding_time_constant,
            ambient_min=ambient_min,
            ambient_max=ambient_max,
            short_time_curve=short_time_curve,
            continuous_curve=continuous_curve,
        )


class CatalogueFiles(Section):
    """Products of other manufacturers, evaluated together with the built-in series."""

    __slots__ = ()
    _TABLE = "catalogue"
    _KEYS = {
        "files": Kind("texts"),
        "cha": Kind("bool"),
    }

    files: tuple[str, ...] | None
    cha: bool | None

    def __init__(
        self,
        *,
        files: Sequence[str] | None = None,
        cha: bool | None = None,
    ) -> None:
        """Args:
            files: Catalogue files in TOML or CSV, relative to the project.
            cha: Built-in series included; default true.
        """
        self._begin(
            files=files,
            cha=cha,
        )


class Measured(Section):
    """Measured values instead of the values of tables and model."""

    __slots__ = ()
    _TABLE = "twin.measured"
    _KEYS = {
        "resistance_ll": Kind("quantity", example="5.9 ohm"),
        "inductance_ll": Kind("quantity", example="8 mH"),
        "torque_constant_motor": Kind("quantity", example="16.5 N m/A"),
        "torque_constant_out": Kind("quantity", example="16.5 N m/A"),
        "voltage_constant_motor": Kind("quantity", example="23 V/1000 1/min"),
        "inertia_out": Kind("quantity", example="1.3 kg m^2"),
        "no_load_starting_current": Kind("quantity", example="2.1 A"),
        "no_load_current_constant_cold": Kind("quantity", example="4e-3 A/(1/min)"),
        "no_load_current_constant_warm": Kind("quantity", example="4e-3 A/(1/min)"),
        "gear_torque_1": Kind("quantity", example="5 N m"),
        "gear_torque_2": Kind("quantity", example="5 N m"),
        "gear_stiffness_1": Kind("quantity", example="67000 N m/rad"),
        "gear_stiffness_2": Kind("quantity", example="67000 N m/rad"),
        "gear_stiffness_3": Kind("quantity", example="67000 N m/rad"),
        "transmission_accuracy": Kind("quantity", example="90 deg"),
        "hysteresis_loss": Kind("quantity", example="90 deg"),
        "lost_motion": Kind("quantity", example="90 deg"),
        "brake_torque": Kind("quantity", example="5 N m"),
        "brake_opening_time": Kind("quantity", example="0.1 s"),
        "brake_closing_time": Kind("quantity", example="0.1 s"),
        "feedback_accuracy": Kind("quantity", example="90 deg"),
        "winding_time_constant": Kind("quantity", example="0.1 s"),
        "housing_time_constant": Kind("quantity", example="0.1 s"),
        "flange_inertia_share": Kind("number", example="0.02"),
        "gear_damping_ratio": Kind("number", example="0.03"),
        "breakaway_ratio": Kind("number", example="1.2"),
        "kinematic_share_1": Kind("number", example="0.15"),
        "kinematic_share_2": Kind("number", example="0.5"),
        "kinematic_share_4": Kind("number", example="0.1"),
        "kinematic_share_out": Kind("number", example="0.25"),
        "sensor_lag": Kind("quantity", example="0.1 s"),
        "ptc_lag": Kind("quantity", example="0.1 s"),
        "ptc_response_temperature": Kind("quantity", example="40 °C"),
        "link_energy": Kind("quantity", example="100 J"),
        "supply_resistance": Kind("quantity", example="5.9 ohm"),
        "brake_resistor": Kind("quantity", example="5.9 ohm"),
        "chopper_on": Kind("number", example="1.15"),
        "chopper_off": Kind("number", example="1.12"),
        "stop_stiffness": Kind("quantity", example="67000 N m/rad"),
        "current_noise": Kind("quantity", example="2.1 A"),
        "load_inertia": Kind("quantity", example="1.3 kg m^2"),
        "load_coulomb": Kind("quantity", example="5 N m"),
        "load_viscous": Kind("quantity", example="0.5 N m s/rad"),
        "load_gravity": Kind("quantity", example="5 N m"),
        "load_gravity_angle": Kind("quantity", example="90 deg"),
        "load_external": Kind("quantity", example="5 N m"),
    }

    resistance_ll: str | None
    inductance_ll: str | None
    torque_constant_motor: str | None
    torque_constant_out: str | None
    voltage_constant_motor: str | None
    inertia_out: str | None
    no_load_starting_current: str | None
    no_load_current_constant_cold: str | None
    no_load_current_constant_warm: str | None
    gear_torque_1: str | None
    gear_torque_2: str | None
    gear_stiffness_1: str | None
    gear_stiffness_2: str | None
    gear_stiffness_3: str | None
    transmission_accuracy: str | None
    hysteresis_loss: str | None
    lost_motion: str | None
    brake_torque: str | None
    brake_opening_time: str | None
    brake_closing_time: str | None
    feedback_accuracy: str | None
    winding_time_constant: str | None
    housing_time_constant: str | None
    flange_inertia_share: float | None
    gear_damping_ratio: float | None
    breakaway_ratio: float | None
    kinematic_share_1: float | None
    kinematic_share_2: float | None
    kinematic_share_4: float | None
    kinematic_share_out: float | None
    sensor_lag: str | None
    ptc_lag: str | None
    ptc_response_temperature: str | None
    link_energy: str | None
    supply_resistance: str | None
    brake_resistor: str | None
    chopper_on: float | None
    chopper_off: float | None
    stop_stiffness: str | None
    current_noise: str | None
    load_inertia: str | None
    load_coulomb: str | None
    load_viscous: str | None
    load_gravity: str | None
    load_gravity_angle: str | None
    load_external: str | None

    def __init__(
        self,
        *,
        resistance_ll: Quantity | None = None,
        inductance_ll: Quantity | None = None,
        torque_constant_motor: Quantity | None = None,
        torque_constant_out: Quantity | None = None,
        voltage_constant_motor: Quantity | None = None,
        inertia_out: Quantity | None = None,
        no_load_starting_current: Quantity | None = None,
        no_load_current_constant_cold: Quantity | None = None,
        no_load_current_constant_warm: Quantity | None = None,
        gear_torque_1: Quantity | None = None,
        gear_torque_2: Quantity | None = None,
        gear_stiffness_1: Quantity | None = None,
        gear_stiffness_2: Quantity | None = None,
        gear_stiffness_3: Quantity | None = None,
        transmission_accuracy: Quantity | None = None,
        hysteresis_loss: Quantity | None = None,
        lost_motion: Quantity | None = None,
        brake_torque: Quantity | None = None,
        brake_opening_time: Quantity | None = None,
        brake_closing_time: Quantity | None = None,
        feedback_accuracy: Quantity | None = None,
        winding_time_constant: Quantity | None = None,
        housing_time_constant: Quantity | None = None,
        flange_inertia_share: float | None = None,
        gear_damping_ratio: float | None = None,
        breakaway_ratio: float | None = None,
        kinematic_share_1: float | None = None,
        kinematic_share_2: float | None = None,
        kinematic_share_4: float | None = None,
        kinematic_share_out: float | None = None,
        sensor_lag: Quantity | None = None,
        ptc_lag: Quantity | None = None,
        ptc_response_temperature: Quantity | None = None,
        link_energy: Quantity | None = None,
        supply_resistance: Quantity | None = None,
        brake_resistor: Quantity | None = None,
        chopper_on: float | None = None,
        chopper_off: float | None = None,
        stop_stiffness: Quantity | None = None,
        current_noise: Quantity | None = None,
        load_inertia: Quantity | None = None,
        load_coulomb: Quantity | None = None,
        load_viscous: Quantity | None = None,
        load_gravity: Quantity | None = None,
        load_gravity_angle: Quantity | None = None,
        load_external: Quantity | None = None,
    ) -> None:
        """Args:
            resistance_ll: Resistance line to line at 20 °C. Resistance such as `"5.9 ohm"`, above zero.
            inductance_ll: Inductance line to line. Inductance such as `"8 mH"`, above zero.
            torque_constant_motor: Torque constant of the motor. Torque constant such as `"16.5 N m/A"`, above zero.
            torque_constant_out: Torque constant at the output, gear losses included. Torque constant such as `"16.5 N m/A"`, above zero.
            voltage_constant_motor: Voltage constant of the motor, line to line, rms. Voltage constant such as `"23 V/1000 1/min"`, above zero.
            inertia_out: Own moment of inertia at the output. Moment of inertia such as `"1.3 kg m^2"`, above zero.
            no_load_starting_current: No-load starting current. Electric current such as `"2.1 A"`, zero or more.
            no_load_current_constant_cold: No-load current constant at the lower temperature of the table. No-load current constant such as `"4e-3 A/(1/min)"`, zero or more.
            no_load_current_constant_warm: No-load current constant at the higher temperature of the table. No-load current constant such as `"4e-3 A/(1/min)"`, zero or more.
            gear_torque_1: End of the first stiffness region. Torque such as `"5 N m"`, above zero.
            gear_torque_2: End of the second stiffness region. Torque such as `"5 N m"`, above zero.
            gear_stiffness_1: Torsional stiffness of the first region. Torsional stiffness such as `"67000 N m/rad"`, above zero.
            gear_stiffness_2: Torsional stiffness of the second region. Torsional stiffness such as `"67000 N m/rad"`, above zero.
            gear_stiffness_3: Torsional stiffness of the third region. Torsional stiffness such as `"67000 N m/rad"`, above zero.
            transmission_accuracy: Transmission accuracy of the gear, peak to peak. Angle such as `"90 deg"`, zero or more.
            hysteresis_loss: Hysteresis loss of the gear. Angle such as `"90 deg"`, zero or more.
            lost_motion: Lost motion of the gear. Angle such as `"90 deg"`, above zero.
            brake_torque: Holding torque of the brake at the output. Torque such as `"5 N m"`, zero or more.
            brake_opening_time: Opening time of the brake. Time such as `"0.1 s"`, zero or more.
            brake_closing_time: Closing time of the brake. Time such as `"0.1 s"`, zero or more.
            feedback_accuracy: Largest deviation of the motor encoder. Angle such as `"90 deg"`, zero or more.
            winding_time_constant: Thermal time constant of the winding. Time such as `"0.1 s"`, above zero.
            housing_time_constant: Thermal time constant of the housing. Time such as `"0.1 s"`, above zero.
            flange_inertia_share: Share of the actuator inertia rotating with the flange. 0 to 0.9.
            gear_damping_ratio: Damping ratio of the gear. 0 to 1.
            breakaway_ratio: Ratio of breakaway torque to running torque at zero speed. 1 to 10.
            kinematic_share_1: Relative amplitude of the kinematic error once per turn of the wave generator; the four amplitudes are scaled together to the transmission accuracy. 0 to 1.
            kinematic_share_2: Relative amplitude twice per turn of the wave generator. 0 to 1.
            kinematic_share_4: Relative amplitude four times per turn of the wave generator. 0 to 1.
            kinematic_share_out: Relative amplitude once per turn of the output. 0 to 1.
            sensor_lag: Time constant of the KTY in the winding. Time such as `"0.1 s"`, zero or more.
            ptc_lag: Time constant of the PTC in the winding. Time such as `"0.1 s"`, zero or more.
            ptc_response_temperature: Response temperature of the PTC. Temperature such as `"40 °C"`, above zero.
            link_energy: Energy in the DC link at nominal supply voltage. Energy such as `"100 J"`, above zero.
            supply_resistance: Internal resistance of the DC link supply. Resistance such as `"5.9 ohm"`, zero or more.
            brake_resistor: Braking resistor. Resistance such as `"5.9 ohm"`, above zero.
            chopper_on: Ratio of the switch-on voltage of the braking resistor to the highest supply voltage. 1 to 2.
            chopper_off: Ratio of the switch-off voltage of the braking resistor to the highest supply voltage. 1 to 2.
            stop_stiffness: Stiffness of the end stop hit by the load. Torsional stiffness such as `"67000 N m/rad"`, above zero.
            current_noise: Noise of a measured phase current, rms. Electric current such as `"2.1 A"`, zero or more.
            load_inertia: Moment of inertia of the load at the output, including the flange. Moment of inertia such as `"1.3 kg m^2"`, above zero.
            load_coulomb: Coulomb friction of the load. Torque such as `"5 N m"`, zero or more.
            load_viscous: Viscous friction of the load. Viscous friction such as `"0.5 N m s/rad"`, zero or more.
            load_gravity: Gravity torque of the load at its largest lever arm. Torque such as `"5 N m"`, zero or more.
            load_gravity_angle: Angle of the centre of mass above the horizontal at position zero. Angle such as `"90 deg"`.
            load_external: External torque of the load. Torque such as `"5 N m"`.
        """
        self._begin(
            resistance_ll=resistance_ll,
            inductance_ll=inductance_ll,
            torque_constant_motor=torque_constant_motor,
            torque_constant_out=torque_constant_out,
            voltage_constant_motor=voltage_constant_motor,
            inertia_out=inertia_out,
            no_load_starting_current=no_load_starting_current,
            no_load_current_constant_cold=no_load_current_constant_cold,
            no_load_current_constant_warm=no_load_current_constant_warm,
            gear_torque_1=gear_torque_1,
            gear_torque_2=gear_torque_2,
            gear_stiffness_1=gear_stiffness_1,
            gear_stiffness_2=gear_stiffness_2,
            gear_stiffness_3=gear_stiffness_3,
            transmission_accuracy=transmission_accuracy,
            hysteresis_loss=hysteresis_loss,
            lost_motion=lost_motion,
            brake_torque=brake_torque,
            brake_opening_time=brake_opening_time,
            brake_closing_time=brake_closing_time,
            feedback_accuracy=feedback_accuracy,
            winding_time_constant=winding_time_constant,
            housing_time_constant=housing_time_constant,
            flange_inertia_share=flange_inertia_share,
            gear_damping_ratio=gear_damping_ratio,
            breakaway_ratio=breakaway_ratio,
            kinematic_share_1=kinematic_share_1,
            kinematic_share_2=kinematic_share_2,
            kinematic_share_4=kinematic_share_4,
            kinematic_share_out=kinematic_share_out,
            sensor_lag=sensor_lag,
            ptc_lag=ptc_lag,
            ptc_response_temperature=ptc_response_temperature,
            link_energy=link_energy,
            supply_resistance=supply_resistance,
            brake_resistor=brake_resistor,
            chopper_on=chopper_on,
            chopper_off=chopper_off,
            stop_stiffness=stop_stiffness,
            current_noise=current_noise,
            load_inertia=load_inertia,
            load_coulomb=load_coulomb,
            load_viscous=load_viscous,
            load_gravity=load_gravity,
            load_gravity_angle=load_gravity_angle,
            load_external=load_external,
        )


class Twin(Section):
    """Settings of the simulation."""

    __slots__ = ()
    _TABLE = "twin"
    _KEYS = {
        "scenario": Kind("word", words=("cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision",)),
        "at": Kind("quantity", example="0.3 s"),
        "reaction": Kind("word", words=("ramp", "brake", "coast",)),
        "failure": Kind("word", words=("track", "amplitude", "cable", "check", "error_bit", "data_line",)),
        "cycles": Kind("integer", example="10"),
        "cold": Kind("bool"),
        "friction": Kind("bool"),
        "hysteresis": Kind("bool"),
        "kinematic_error": Kind("bool"),
        "delay": Kind("bool"),
        "limits": Kind("bool"),
        "noise": Kind("bool"),
        "position_gain": Kind("quantity", example="25 1/s"),
        "speed_gain": Kind("quantity", example="900 N m s/rad"),
        "speed_time": Kind("quantity", example="5 ms"),
        "speed_filter": Kind("quantity", example="0.2 ms"),
        "current_gain": Kind("quantity", example="20 V/A"),
        "current_time": Kind("quantity", example="1.4 ms"),
        "following_error_max": Kind("quantity", example="1 deg"),
        "measured": Kind("table", table="Measured"),
    }

    scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None
    at: str | None
    reaction: Literal["ramp", "brake", "coast"] | None
    failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None
    cycles: int | None
    cold: bool | None
    friction: bool | None
    hysteresis: bool | None
    kinematic_error: bool | None
    delay: bool | None
    limits: bool | None
    noise: bool | None
    position_gain: str | None
    speed_gain: str | None
    speed_time: str | None
    speed_filter: str | None
    current_gain: str | None
    current_time: str | None
    following_error_max: str | None
    measured: Measured | None

    def __init__(
        self,
        *,
        scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None = None,
        at: Quantity | None = None,
        reaction: Literal["ramp", "brake", "coast"] | None = None,
        failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None = None,
        cycles: int | None = None,
        cold: bool | None = None,
        friction: bool | None = None,
        hysteresis: bool | None = None,
        kinematic_error: bool | None = None,
        delay: bool | None = None,
        limits: bool | None = None,
        noise: bool | None = None,
        position_gain: Quantity | None = None,
        speed_gain: Quantity | None = None,
        speed_time: Quantity | None = None,
        speed_filter: Quantity | None = None,
        current_gain: Quantity | None = None,
        current_time: Quantity | None = None,
        following_error_max: Quantity | None = None,
        measured: Measured | None = None,
    ) -> None:
        """Args:
            scenario: Scenario of the simulation.
            at: Time at which the scenario occurs. Time such as `"0.3 s"`, zero or more.
            reaction: Stop reaction of the drive.
            failure: Type of encoder failure; default: signal loss.
            cycles: Number of cycles simulated. 1 to 100000.
            cold: True: start at ambient temperature.
            friction: False: friction of motor and gear is neglected.
            hysteresis: False: hysteresis of the gear is neglected.
            kinematic_error: False: kinematic error of the gear is neglected.
            delay: False: sampling delay of the current loop is neglected.
            limits: False: limits and monitoring of the drive are neglected.
            noise: False: errors of the measured angle and current are neglected.
            position_gain: K_v of the position loop. Position gain such as `"25 1/s"`, above zero.
            speed_gain: K_p of the speed loop at the output. Speed gain such as `"900 N m s/rad"`, above zero.
            speed_time: Integral-action time of the speed loop. Time such as `"5 ms"`, above zero.
            speed_filter: Time constant of the speed actual value filter. Time such as `"0.2 ms"`, zero or more.
            current_gain: K_p of the current loop per phase. Current gain such as `"20 V/A"`, above zero.
            current_time: Integral-action time of the current loop. Time such as `"1.4 ms"`, above zero.
            following_error_max: Following error at which the drive stops. Angle such as `"1 deg"`, above zero.
            measured: Measured values instead of the values of tables and model.
        """
        self._begin(
            scenario=scenario,
            at=at,
            reaction=reaction,
            failure=failure,
            cycles=cycles,
            cold=cold,
            friction=friction,
            hysteresis=hysteresis,
            kinematic_error=kinematic_error,
            delay=delay,
            limits=limits,
            noise=noise,
            position_gain=position_gain,
            speed_gain=speed_gain,
            speed_time=speed_time,
            speed_filter=speed_filter,
            current_gain=current_gain,
            current_time=current_time,
            following_error_max=following_error_max,
            measured=measured,
        )


class Curve(Section):
    """Measured or digitised torque-speed curves; they take precedence over those of the catalogue."""

    __slots__ = ()
    _TABLE = "curve"
    _PLACES = ("kind",)
    _NEEDED = ("kind",)
    _KEYS = {
        "kind": Kind("word", words=("continuous", "s3_50", "s3_25", "short_time",)),
        "code": Kind("text"),
        "points": Kind("rows", example="[[\"0 1/min\", \"32 N m\"], [\"40 1/min\", \"25 N m\"]]", columns=2),
        "source": Kind("text"),
    }

    kind: Literal["continuous", "s3_50", "s3_25", "short_time"]
    code: str | None
    points: tuple[tuple[str, ...], ...] | None
    source: str | None

    def __init__(
        self,
        kind: Literal["continuous", "s3_50", "s3_25", "short_time"],
        *,
        code: str | None = None,
        points: Sequence[tuple[Quantity, Quantity]] | None = None,
        source: str | None = None,
    ) -> None:
        """Args:
            kind: Type of limit.
            code: Ordering codes for which the curve is valid; * stands for any field: CHA-25A-100-*.
            points: Corner points from standstill, speed and torque at the output.
            source: Source of the curve.
        """
        self._begin(
            kind=kind,
            code=code,
            points=points,
            source=source,
        )


class Axis(BaseAxis):
    """An axis: a load or a mechanism, its motion, and what is required of the actuator.

    Every function that takes a project takes an axis, a list of axes, or a `Project`.
    """

    __slots__ = ()
    _REQUIREMENTS = (
        "feedback",
        "brake",
        "hollow_shaft_min",
        "length_max",
        "mass_max",
        "makers",
        "price_max",
        "lead_time_max",
        "supply",
        "mains",
        "mains_phases",
        "mains_deviation",
        "modulation_reserve",
        "ambient",
        "altitude",
        "altitude_derating",
        "protection",
        "humidity_min",
        "humidity_max",
        "vibration",
        "shock",
        "mounting",
        "bearing_life_min",
        "gear_life_min",
        "torsion_max",
        "natural_frequency_min",
        "tilt_angle_max",
        "angle_error_max",
        "lever_arm",
        "deviation_max",
        "resolution_max",
        "absolute",
        "stop_angle_max",
        "emergency_stops",
        "holding_safety",
        "service_life",
        "regeneration_power_max",
        "operation_per_day",
        "storage",
        "battery_life_min",
        "collision_torque",
        "collision_time",
        "collisions",
        "position_loop",
        "dc_link_rise",
        "special_application",
        "leave_out",
        "option_1",
        "option_2",
    )
    _PLACES = ("name", "mechanism", "motion")
    _NEEDED = ("mechanism", "motion")
    _KEYS = {
        "name": Kind("text"),
        "mechanism": Kind("mechanism"),
        "motion": Kind("tables", table="Segment"),
        "single_move": Kind("bool"),
        "stage": Kind("table", table="Stage"),
        "bearing": Kind("table", table="Bearing"),
        "drive": Kind("table", table="Drive"),
        "actuator": Kind("table", table="Actuator"),
        "twin": Kind("table", table="Twin"),
        "curve": Kind("tables", table="Curve"),
        "catalogue": Kind("table", table="CatalogueFiles"),
        "feedback": Kind("words", words=("C1024", "M512P", "RES", "D2048", "M128S",)),
        "brake": Kind("bool"),
        "hollow_shaft_min": Kind("quantity", example="18 mm"),
        "length_max": Kind("quantity", example="200 mm"),
        "mass_max": Kind("quantity", example="10 kg"),
        "makers": Kind("texts"),
        "price_max": Kind("text"),
        "lead_time_max": Kind("quantity", example="60 d"),
        "supply": Kind("quantity", example="560 V"),
        "mains": Kind("quantity", example="400 V"),
        "mains_phases": Kind("word", words=("single", "three",)),
        "mains_deviation": Kind("number", example="0.1"),
        "modulation_reserve": Kind("number", example="0.9"),
        "ambient": Kind("quantity", example="40 °C"),
        "altitude": Kind("quantity", example="800 m"),
        "altitude_derating": Kind("number", example="0.9"),
        "protection": Kind("word", words=("IP00", "IP10", "IP12", "IP13", "IP20", "IP21", "IP22", "IP23", "IP43", "IP44", "IP54", "IP55", "IP56", "IP64", "IP65", "IP66", "IP67", "IP68", "IP69",)),
        "humidity_min": Kind("number", example="0.3"),
        "humidity_max": Kind("number", example="0.75"),
        "vibration": Kind("quantity", example="2 g"),
        "shock": Kind("quantity", example="15 g"),
        "mounting": Kind("word", words=("horizontal", "flange_up", "flange_down", "changing",)),
        "bearing_life_min": Kind("quantity", example="20000 h"),
        "gear_life_min": Kind("quantity", example="20000 h"),
        "torsion_max": Kind("quantity", example="2 arcmin"),
        "natural_frequency_min": Kind("quantity", example="25 Hz"),
        "tilt_angle_max": Kind("quantity", example="2 arcmin"),
        "angle_error_max": Kind("quantity", example="2 arcmin"),
        "lever_arm": Kind("quantity", example="500 mm"),
        "deviation_max": Kind("quantity", example="0.2 mm"),
        "resolution_max": Kind("quantity", example="5 arcsec"),
        "absolute": Kind("bool"),
        "stop_angle_max": Kind("quantity", example="90 deg"),
        "emergency_stops": Kind("integer", example="200"),
        "holding_safety": Kind("number", example="1.5"),
        "service_life": Kind("quantity", example="20000 h"),
        "regeneration_power_max": Kind("quantity", example="250 W"),
        "operation_per_day": Kind("quantity", example="10 h"),
        "storage": Kind("quantity", example="720 h"),
        "battery_life_min": Kind("quantity", example="20000 h"),
        "collision_torque": Kind("quantity", example="5 N m"),
        "collision_time": Kind("quantity", example="0.1 s"),
        "collisions": Kind("integer", example="10"),
        "position_loop": Kind("word", words=("motor", "output",)),
        "dc_link_rise": Kind("quantity", example="40 V"),
        "special_application": Kind("word", words=("aerospace", "explosive_atmosphere", "nuclear", "vacuum", "household", "medical", "human_contact", "lifting_of_persons", "amusement",)),
        "leave_out": Kind("words", words=("supply", "flange_loads", "conditions", "application",)),
        "option_1": Kind("word", words=("EC",)),
        "option_2": Kind("word", words=("K", "R", "S",)),
    }

    name: str | None
    mechanism: LoadOrMechanism
    motion: tuple[Segment, ...]
    single_move: bool | None
    stage: Stage | None
    bearing: Bearing | None
    drive: Drive | None
    actuator: Actuator | None
    twin: Twin | None
    curve: tuple[Curve, ...] | None
    catalogue: CatalogueFiles | None
    feedback: tuple[str, ...] | None
    brake: bool | None
    hollow_shaft_min: str | None
    length_max: str | None
    mass_max: str | None
    makers: tuple[str, ...] | None
    price_max: str | None
    lead_time_max: str | None
    supply: str | None
    mains: str | None
    mains_phases: Literal["single", "three"] | None
    mains_deviation: float | None
    modulation_reserve: float | None
    ambient: str | None
    altitude: str | None
    altitude_derating: float | None
    protection: Literal["IP00", "IP10", "IP12", "IP13", "IP20", "IP21", "IP22", "IP23", "IP43", "IP44", "IP54", "IP55", "IP56", "IP64", "IP65", "IP66", "IP67", "IP68", "IP69"] | None
    humidity_min: float | None
    humidity_max: float | None
    vibration: str | None
    shock: str | None
    mounting: Literal["horizontal", "flange_up", "flange_down", "changing"] | None
    bearing_life_min: str | None
    gear_life_min: str | None
    torsion_max: str | None
    natural_frequency_min: str | None
    tilt_angle_max: str | None
    angle_error_max: str | None
    lever_arm: str | None
    deviation_max: str | None
    resolution_max: str | None
    absolute: bool | None
    stop_angle_max: str | None
    emergency_stops: int | None
    holding_safety: float | None
    service_life: str | None
    regeneration_power_max: str | None
    operation_per_day: str | None
    storage: str | None
    battery_life_min: str | None
    collision_torque: str | None
    collision_time: str | None
    collisions: int | None
    position_loop: Literal["motor", "output"] | None
    dc_link_rise: str | None
    special_application: Literal["aerospace", "explosive_atmosphere", "nuclear", "vacuum", "household", "medical", "human_contact", "lifting_of_persons", "amusement"] | None
    leave_out: tuple[str, ...] | None
    option_1: Literal["EC"] | None
    option_2: Literal["K", "R", "S"] | None

    def __init__(
        self,
        name: str | None,
        mechanism: LoadOrMechanism,
        motion: Sequence[Segment] | Segment,
        *,
        single_move: bool | None = None,
        stage: Stage | None = None,
        bearing: Bearing | None = None,
        drive: Drive | None = None,
        actuator: Actuator | None = None,
        twin: Twin | None = None,
        curve: Sequence[Curve] | None = None,
        catalogue: CatalogueFiles | None = None,
        feedback: Literal["C1024", "M512P", "RES", "D2048", "M128S"] | Sequence[Literal["C1024", "M512P", "RES", "D2048", "M128S"]] | None = None,
        brake: bool | None = None,
        hollow_shaft_min: Quantity | None = None,
        length_max: Quantity | None = None,
        mass_max: Quantity | None = None,
        makers: Sequence[str] | None = None,
        price_max: str | None = None,
        lead_time_max: Quantity | None = None,
        supply: Quantity | None = None,
        mains: Quantity | None = None,
        mains_phases: Literal["single", "three"] | None = None,
        mains_deviation: float | None = None,
        modulation_reserve: float | None = None,
        ambient: Quantity | None = None,
        altitude: Quantity | None = None,
        altitude_derating: float | None = None,
        protection: Literal["IP00", "IP10", "IP12", "IP13", "IP20", "IP21", "IP22", "IP23", "IP43", "IP44", "IP54", "IP55", "IP56", "IP64", "IP65", "IP66", "IP67", "IP68", "IP69"] | None = None,
        humidity_min: float | None = None,
        humidity_max: float | None = None,
        vibration: Quantity | None = None,
        shock: Quantity | None = None,
        mounting: Literal["horizontal", "flange_up", "flange_down", "changing"] | None = None,
        bearing_life_min: Quantity | None = None,
        gear_life_min: Quantity | None = None,
        torsion_max: Quantity | None = None,
        natural_frequency_min: Quantity | None = None,
        tilt_angle_max: Quantity | None = None,
        angle_error_max: Quantity | None = None,
        lever_arm: Quantity | None = None,
        deviation_max: Quantity | None = None,
        resolution_max: Quantity | None = None,
        absolute: bool | None = None,
        stop_angle_max: Quantity | None = None,
        emergency_stops: int | None = None,
        holding_safety: float | None = None,
        service_life: Quantity | None = None,
        regeneration_power_max: Quantity | None = None,
        operation_per_day: Quantity | None = None,
        storage: Quantity | None = None,
        battery_life_min: Quantity | None = None,
        collision_torque: Quantity | None = None,
        collision_time: Quantity | None = None,
        collisions: int | None = None,
        position_loop: Literal["motor", "output"] | None = None,
        dc_link_rise: Quantity | None = None,
        special_application: Literal["aerospace", "explosive_atmosphere", "nuclear", "vacuum", "household", "medical", "human_contact", "lifting_of_persons", "amusement"] | None = None,
        leave_out: Literal["supply", "flange_loads", "conditions", "application"] | Sequence[Literal["supply", "flange_loads", "conditions", "application"]] | None = None,
        option_1: Literal["EC"] | None = None,
        option_2: Literal["K", "R", "S"] | None = None,
    ) -> None:
        """Args:
            name: Name of the axis; `None` leaves a single axis without one.
            mechanism: The load at the output, or the mechanism between output and load.
            motion: The segments of the motion in their order.
            single_move: True: the motion is a single move and does not have to return.
            stage: Belt, gear or coupling between actuator and mechanism.
            bearing: Loads on the output flange.
            drive: The drive that supplies the motor.
            actuator: An actuator not contained in the catalogue.
            twin: Settings of the simulation.
            curve: Measured or digitised torque-speed curves; they take precedence over those of the catalogue.
            catalogue: Products of other manufacturers, evaluated together with the built-in series.
            feedback: Permitted motor encoders; default: any.
            brake: Holding brake; true: required, false: excluded; default: either.
            hollow_shaft_min: Minimum hollow shaft bore diameter. Length such as `"18 mm"`, zero or more.
            length_max: Maximum length of the actuator. Length such as `"200 mm"`, above zero.
            mass_max: Maximum mass of the actuator. Mass such as `"10 kg"`, above zero.
            makers: Permitted manufacturers, each by its name or the first words of it; default: any.
            price_max: Maximum price with its currency; compared with the prices of catalogue files.
            lead_time_max: Maximum lead time; compared with those of catalogue files. Time such as `"60 d"`, above zero.
            supply: DC link voltage; without it, the terminal voltage is not checked, listed as assumed. Voltage such as `"560 V"`, above zero.
            mains: Mains voltage, line to line, rms; instead of the DC link voltage; each check uses the less favourable limit. Effective voltage such as `"400 V"`, above zero.
            mains_phases: Number of mains phases; default: three.
            mains_deviation: Relative deviation of the mains voltage in both directions; default 0.1. 0 to 0.5.
            modulation_reserve: Share of U_DC/√2 that the drive can provide as fundamental; default 0.9, listed as assumed. 0.5 to 1.
            ambient: Ambient temperature in operation; default: the range of the manufacturer's data, listed as assumed. Temperature such as `"40 °C"`.
            altitude: Altitude of the place of installation above sea level. Length such as `"800 m"`.
            altitude_derating: Share of the continuous torque that is available at this altitude, as confirmed by the manufacturer; the manual states none. 0.1 to 1.
            protection: Required degree of protection (EN 60034-5).
            humidity_min: Lowest relative humidity at the place of installation, without condensation. 0 to 1.
            humidity_max: Highest relative humidity at the place of installation, without condensation. 0 to 1.
            vibration: Vibration at the place of installation, peak value of the acceleration. Acceleration such as `"2 g"`, zero or more.
            shock: Largest shock at the place of installation, peak value of the acceleration. Acceleration such as `"15 g"`, zero or more.
            mounting: Mounting position of the actuator; the manual states no permissible positions.
            bearing_life_min: Required life of the output bearing. Time such as `"20000 h"`, above zero.
            gear_life_min: Required life of the wave generator bearing. Time such as `"20000 h"`, above zero.
            torsion_max: Permissible torsion angle of gear and stage under the largest torque, with a stage at the mechanism. Angle such as `"2 arcmin"`, above zero.
            natural_frequency_min: Minimum first natural frequency with locked motor. Frequency such as `"25 Hz"`, above zero.
            tilt_angle_max: Permissible tilt of the flange under the tilting moment. Angle such as `"2 arcmin"`, above zero.
            angle_error_max: Permissible sum of all angular errors at the output, with a stage at the mechanism. Angle such as `"2 arcmin"`, above zero.
            lever_arm: Lever arm: distance from the axis at which the deviation is evaluated. Length such as `"500 mm"`, above zero.
            deviation_max: Permissible deviation at the lever arm, or along the line of a linear mechanism. Length such as `"0.2 mm"`, above zero.
            resolution_max: Largest permissible position step at the output. Angle such as `"5 arcsec"`, above zero.
            absolute: True: the position must be absolute over the whole travel.
            stop_angle_max: Permissible angle of a stop by the brake alone. Angle such as `"90 deg"`, above zero.
            emergency_stops: Number of stops by the brake alone. 0 to 1000000.
            holding_safety: Required ratio of brake holding torque to load torque; default 1. 1 to 100.
            service_life: Operating time over the life of the axis, for the number of brake applications. Time such as `"20000 h"`, above zero.
            regeneration_power_max: Mean power that the supply or the braking resistor can absorb. Power such as `"250 W"`, above zero.
            operation_per_day: Operation per day, for the encoder battery. Time such as `"10 h"`, zero or more.
            storage: Storage before operation, for the encoder battery; default: none. Time such as `"720 h"`, zero or more.
            battery_life_min: Required battery life. Time such as `"20000 h"`, above zero.
            collision_torque: Largest torque of a collision at the output. Torque such as `"5 N m"`, above zero.
            collision_time: Duration of a collision. Time such as `"0.1 s"`, above zero.
            collisions: Number of collisions over the life of the axis. 0 to 1000000.
            position_loop: Encoder through which the position loop is closed; output requires option EC; default: the motor encoder.
            dc_link_rise: Permissible rise of the DC link voltage for sizing a capacitor bank. Voltage such as `"40 V"`, above zero.
            special_application: Field of application that requires the manufacturer's approval (section 2.4); default: none, listed as assumed.
            leave_out: Data left out knowingly: what depends on them is not checked.
            option_1: Sensor option.
            option_2: Option 2 (cable, connector).
        """
        self._begin(
            name=name,
            mechanism=mechanism,
            motion=motion,
            single_move=single_move,
            stage=stage,
            bearing=bearing,
            drive=drive,
            actuator=actuator,
            twin=twin,
            curve=curve,
            catalogue=catalogue,
            feedback=feedback,
            brake=brake,
            hollow_shaft_min=hollow_shaft_min,
            length_max=length_max,
            mass_max=mass_max,
            makers=makers,
            price_max=price_max,
            lead_time_max=lead_time_max,
            supply=supply,
            mains=mains,
            mains_phases=mains_phases,
            mains_deviation=mains_deviation,
            modulation_reserve=modulation_reserve,
            ambient=ambient,
            altitude=altitude,
            altitude_derating=altitude_derating,
            protection=protection,
            humidity_min=humidity_min,
            humidity_max=humidity_max,
            vibration=vibration,
            shock=shock,
            mounting=mounting,
            bearing_life_min=bearing_life_min,
            gear_life_min=gear_life_min,
            torsion_max=torsion_max,
            natural_frequency_min=natural_frequency_min,
            tilt_angle_max=tilt_angle_max,
            angle_error_max=angle_error_max,
            lever_arm=lever_arm,
            deviation_max=deviation_max,
            resolution_max=resolution_max,
            absolute=absolute,
            stop_angle_max=stop_angle_max,
            emergency_stops=emergency_stops,
            holding_safety=holding_safety,
            service_life=service_life,
            regeneration_power_max=regeneration_power_max,
            operation_per_day=operation_per_day,
            storage=storage,
            battery_life_min=battery_life_min,
            collision_torque=collision_torque,
            collision_time=collision_time,
            collisions=collisions,
            position_loop=position_loop,
            dc_link_rise=dc_link_rise,
            special_application=special_application,
            leave_out=leave_out,
            option_1=option_1,
            option_2=option_2,
        )


class Project(BaseProject):
    """Several axes in one project, and the curves of actuators that they share."""

    __slots__ = ()
    _KEYS = {
        "axis": Kind("tables", table="Axis"),
        "curve": Kind("tables", table="Curve"),
        "catalogue": Kind("table", table="CatalogueFiles"),
    }
    _PLACES = ("axis",)

    axis: tuple[Axis, ...]
    curve: tuple[Curve, ...] | None
    catalogue: CatalogueFiles | None

    def __init__(self, axis: Sequence[Axis], *, curve: Sequence[Curve] | None = None, catalogue: CatalogueFiles | None = None) -> None:
        """Args:
            axis: The axes, each with a name of its own.
            curve: Curves of the user for actuators of the catalogue.
            catalogue: Catalogue files, whose products are judged beside the built-in series.
        """
        self._begin(axis=axis, curve=curve, catalogue=catalogue)


__all__ = [
    "Actuator",
    "Arm",
    "Axis",
    "Bearing",
    "Belt",
    "Body",
    "CatalogueFiles",
    "Columns",
    "Conveyor",
    "Curve",
    "Drive",
    "Dwell",
    "FlangeLoads",
    "FourBar",
    "Hoist",
    "Joint",
    "Load",
    "Manual",
    "Measured",
    "Move",
    "Points",
    "Project",
    "Recorded",
    "RecordedRatio",
    "Return",
    "ScissorLift",
    "Screw",
    "SliderCrank",
    "Stage",
    "TableMechanism",
    "Turntable",
    "Twin",
    "Units",
    "Web",
    "Winder",
]
