# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done to force curves before they are written: calibration, the direction of the height, segments, the tip, contact."""

from dataclasses import dataclass, field

import numpy as np

from .problems import BadInput

# a curve has so many samples at least
FEWEST_SAMPLES = 10
# the ends of a curve are so large a part of its height; the end in contact is so many times as uneven as the other one
END, UNEVEN = 0.1, 2.0
# the end in contact is this many times the noise above the other one, and a load that far from the base line is contact
CLEAR = 5.0
# of the clear curves at most this part may show the other direction
FEW = 0.1
# a segment along which the height changes by less than this part of that of the curve is a dwell
STILL = 0.1
# so many samples at the turning point are a dwell, where the file states no segments
FEWEST_DWELL = 6
# the base line is the part of a segment that is at least so far from the end in contact, in parts of its range
OUTER = 0.6
# between what is clearly contact and what is clearly free lie so many times the distance in which the load doubles
BETWEEN = 4.0
# noise is at least this part of the range of the load
FINEST = 1e-5
STATUS = ("used", "unreadable", "few_samples", "no_motion", "contrary", "no_contact", "missing")
APPROACH, DWELL, RETRACTION, NOTHING = 0, 1, 2, -1
SEGMENTS = ("approach", "dwell", "retraction")


@dataclass
class Treated:
    """A curve as it is written: heights rise towards the surface, and loads are positive where it is pressed."""

    name: str
    status: str = "used"
    problem: str = ""
    # position of the base and of the tip [m], deflection [m], load [N], time [s]; None where nothing is known
    columns: dict = field(default_factory=dict)
    segment: np.ndarray | None = None
    # 1 in contact, 0 free, not a number where that is not clear
    contact: np.ndarray | None = None
    spring_constant: float | None = None
    sensitivity: float | None = None
    # standard deviation of the load on the base line [N]
    noise: float = np.nan
    dropped: int = 0
    source: object = None


def treat(source, given, path):
    """The curves of a file, and 1 or -1: does its height rise towards the surface?"""
    for curve in source.curves:
        if not curve.problem:
            calibrate(curve, given, path)
            check(curve)
    direction, votes, remarks = find_direction(source.curves, given, path)
    return [finish(curve, direction, vote, given) for curve, vote in zip(source.curves, votes)], direction, remarks


def calibrate(curve, given, path):
    """Load and deflection from what the file has and from what the options say of the lever."""
    stiffness = given.spring_constant or curve.spring_constant
    if curve.load is None and stiffness is None:
        raise BadInput(f"{path}: the file states a deflection and no spring constant: give --spring-constant in N/m")
    if curve.load is None:
        curve.deflection = curve.deflection * scale_of_sensitivity(curve, given)
        curve.load = stiffness * curve.deflection
    else:
        if curve.deflection is None and curve.spring_constant:
            curve.deflection = curve.load / curve.spring_constant * scale_of_sensitivity(curve, given)
            if given.spring_constant or given.sensitivity:
                curve.load = stiffness * curve.deflection
        elif curve.deflection is None and stiffness:
            curve.deflection = curve.load / stiffness
        elif curve.deflection is not None:
            agree(curve, stiffness, path)
    if given.flip_load:
        curve.load, curve.deflection = -curve.load, None if curve.deflection is None else -curve.deflection
    if not curve.is_tip and curve.deflection is None:
        raise BadInput(f"{path}: the file states no spring constant, so the height of the tip is not known: give --spring-constant in "
                       "N/m, or --tip where the height is that of the tip")
    curve.spring_constant, curve.sensitivity = stiffness or curve.spring_constant, given.sensitivity or curve.sensitivity


def scale_of_sensitivity(curve, given):
    """What another sensitivity makes of the deflection."""
    return given.sensitivity / curve.sensitivity if given.sensitivity and curve.sensitivity else 1.0


def agree(curve, stiffness, path):
    """Load and deflection of a file must have the spring constant as their ratio; it is found from them where nothing states it."""
    is_number = np.isfinite(curve.load) & np.isfinite(curve.deflection)
    load, deflection = (values[is_number] - values[is_number].mean() for values in (curve.load, curve.deflection))
    if not deflection.any():
        return
    found = float(load @ deflection / (deflection @ deflection))
    rest = np.std(load - found * deflection) / max(np.std(load), np.finfo(float).tiny)
    if rest > 0.02 or found <= 0:
        raise BadInput(f"{path}: load and deflection of {curve.name} are not proportional: choose one by --load-column or "
                       "--deflection-column")
    if stiffness and abs(found - stiffness) > 0.02 * stiffness:
        raise BadInput(f"{path}: load over deflection of {curve.name} is {found:.4g} N/m, the spring constant {stiffness:.4g} N/m")
    curve.spring_constant = stiffness or found


def check(curve):
    """Can a curve be used?"""
    is_number = np.isfinite(curve.height) & np.isfinite(curve.load)
    if is_number.sum() < FEWEST_SAMPLES:
        curve.problem = f"has {int(is_number.sum())} samples, allowed: at least {FEWEST_SAMPLES}"
    elif np.ptp(curve.height[is_number]) == 0:
        curve.problem = "has one height alone"


def find_direction(curves, given, path):
    """1 where heights rise towards the surface, -1 where they fall, as the option says or most curves show; and what each shows."""
    votes = [0 if curve.problem else vote_of(curve) for curve in curves]
    towards, away, falls = (sum(vote == wanted for vote in votes) for wanted in (1, -1, None))
    votes = [vote or 0 for vote in votes]
    remarks = []
    if given.sign:
        direction = 1 if given.sign == "towards" else -1
        if away if direction == 1 else towards:
            remarks.append(f"{away if direction == 1 else towards} of {len(curves)} curves look as if heights rose "
                           f"{'away from' if direction == 1 else 'towards'} the surface, --sign says otherwise")
        return direction, [0] * len(votes), remarks
    if not towards and not away or min(towards, away) > FEW * max(towards, away):
        why = f"{towards} curves show heights that rise towards the surface, {away} away from it"
        if falls > towards + away:
            why = f"the load falls where it is uneven in {falls} curves (--flip-load if it is negative where the surface is pressed)"
        raise BadInput(f"{path}: which end of the heights is in contact is not clear, {why}: give --sign towards or --sign away")
    return 1 if towards > away else -1, votes, remarks


def vote_of(curve):
    """Where the load rises: 1 with the height, -1 against it, 0 if that is not clear; None where the uneven end has the lower load."""
    is_number = np.isfinite(curve.height) & np.isfinite(curve.load)
    height, load = curve.height[is_number], curve.load[is_number]
    order = np.argsort(height, kind="stable")
    tips = [np.median(load[order[part]]) for part in (slice(max(3, len(order) // 100)), slice(-max(3, len(order) // 100), None))]
    width, noise, rise = END * np.ptp(height), noise_of(load), tips[1] - tips[0]
    uneven = [np.ptp(end) for end in (load[height <= height.min() + width], load[height >= height.max() - width])]
    rough = 1 if uneven[1] > UNEVEN * uneven[0] else -1 if uneven[0] > UNEVEN * uneven[1] else 0
    if not rough or abs(rise) <= CLEAR * noise:
        return 0
    return rough if rough * rise > 0 else None


def noise_of(load):
    """Standard deviation of the noise of neighbouring samples."""
    steps = np.abs(np.diff(load))
    return 1.4826 * float(np.median(steps)) / np.sqrt(2) if steps.size else 0.0


def finish(curve, direction, vote, given):
    """A curve with its height towards the surface."""
    treated = Treated(curve.name, source=curve, spring_constant=curve.spring_constant, sensitivity=curve.sensitivity)
    if curve.problem:
        treated.problem = curve.problem
        treated.status = ("unreadable" if curve.problem.startswith("cannot") else
                          "no_motion" if "height" in curve.problem else "few_samples")
        return treated
    if vote == -direction:
        treated.status, treated.problem = "contrary", "its load rises where heights are far from the surface in the other curves"
        return treated
    is_number = np.isfinite(curve.height) & np.isfinite(curve.load)
    treated.dropped = int((~is_number).sum())
    height, load = direction * curve.height[is_number], curve.load[is_number]
    deflection = None if curve.deflection is None else curve.deflection[is_number]
    treated.columns = {"load": load, "deflection": deflection, "time": None if curve.time is None else curve.time[is_number]}
    if curve.is_tip:
        treated.columns["approach"] = height
        treated.columns["position"] = None if deflection is None else height + deflection
    else:
        treated.columns["position"], treated.columns["approach"] = height, height - deflection
    drive = height if treated.columns["position"] is None else treated.columns["position"]
    treated.segment = segments_of(drive, None if curve.segment is None else curve.segment[is_number])
    treated.contact, treated.noise = contact_of(drive, load, treated.segment)
    if not (treated.contact == 1).any():
        treated.status, treated.problem = "no_contact", "no load rises above its base line: it has no contact"
    return treated


def segments_of(position, stated):
    """Approach, dwell or retraction of each sample: those that the file states, by their motion, or the two sides of the turning point."""
    span = np.ptp(position)
    if stated is not None and np.nanmin(stated) != np.nanmax(stated):
        segment = np.full(len(position), NOTHING, np.int8)
        edges = np.flatnonzero(np.diff(stated)) + 1
        for part in np.split(np.arange(len(position)), edges):
            motion = position[part[-1]] - position[part[0]]
            segment[part] = DWELL if abs(motion) < STILL * span else APPROACH if motion > 0 else RETRACTION
        return segment
    segment = np.full(len(position), APPROACH, np.int8)
    highest = position.max()
    arrival = int(np.argmax(position >= highest - 0.01 * span))
    start = int(np.argmin(position[:arrival + 1]))
    # the step of a ramp
    step = span / max(1, arrival - start)
    top = np.flatnonzero(position >= highest - 1.5 * step)
    first, last = int(top[0]), int(top[-1])
    if last - first + 1 >= FEWEST_DWELL:
        segment[first + 1:last] = DWELL
        segment[last:] = RETRACTION
    else:
        segment[int(np.argmax(position)) + 1:] = RETRACTION
    if segment[-1] == RETRACTION and last == len(position) - 1:
        # it ends in the dwell
        segment[last] = DWELL if last > first + 1 else APPROACH
    return segment


def contact_of(position, load, segment):
    """Contact (1), free (0) or not clear (not a number) of each sample, and the noise of the load on the base line [N]."""
    contact, noises = np.full(len(load), np.nan), []
    for which in (APPROACH, RETRACTION):
        part = np.flatnonzero(segment == which)
        if len(part) >= FEWEST_SAMPLES:
            # from the end in contact outwards
            part = part[np.argsort(-position[part], kind="stable")]
            contact[part], noise = contact_of_segment(position[part], load[part])
            noises.append(noise)
    if (contact == 1).any():
        contact[segment == DWELL] = 1
    return contact, float(np.mean(noises)) if noises else np.nan


def contact_of_segment(position, load):
    """The same of a segment that is ordered from the end in contact outwards."""
    contact = np.full(len(load), np.nan)
    outer = position <= position[0] - OUTER * (position[0] - position[-1])
    if outer.sum() < FEWEST_SAMPLES // 2:
        return contact, noise_of(load)
    # the base line may be tilted; a contact that reaches into it is told by its unevenness
    trend = np.polyfit(position[outer] - position[-1], load[outer], 1)
    rest = load - np.polyval(trend, position - position[-1])
    # numbers without noise have round-off
    noise = max(float(np.std(rest[outer])), FINEST * float(np.ptp(load)))
    far = np.abs(rest) > CLEAR * noise
    inner = np.flatnonzero(far & ~outer)
    # one sample that is far away is none
    inner = inner[np.isin(inner - 1, inner) | np.isin(inner + 1, inner)]
    if not inner.size:
        return np.zeros(len(load)) if not far.any() else contact, noise
    last = int(inner[-1])
    least = int(np.argmin(rest[:last + 1]))
    # what follows the largest pull is a jump, or at least no state that is known
    contact[:1 + (least if rest[least] < -CLEAR * noise else last)] = 1
    twice = np.flatnonzero(np.abs(rest[:last + 1]) > 2 * CLEAR * noise)
    gap = abs(position[int(twice[-1])] - position[last]) if twice.size else 0.0
    beyond = position < position[last] - max(BETWEEN * gap, 2 * abs(position[0] - position[-1]) / len(position))
    contact[(np.arange(len(load)) > last) & beyond] = 0
    return contact, noise
