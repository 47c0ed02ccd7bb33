# SPDX-License-Identifier: GPL-3.0-or-later
"""One contact, for codes that solve many: arrays of contacts in reduced variables, or in SI units by `sphere_scales`.

Arguments are numbers or arrays that are broadcast to one shape; what is found has that shape. `status` is 0 where a contact was
solved, 1 where there is no equilibrium, 2 where it has not converged, -2 where an argument is NaN or not allowed; all else that is
found is NaN then. A call costs a few microseconds, whatever it solves, and starts no threads.
"""

from collections import namedtuple

import numpy as np

from .errors import InputError
from .library import library

Scales = namedtuple("Scales", "length closer force strength")
SphereContact = namedtuple("SphereContact", "contact_radius adhesion_radius approach status")
SphereContactAtApproach = namedtuple("SphereContactAtApproach", "contact_radius adhesion_radius load status")
SphereContactOfRadius = namedtuple("SphereContactOfRadius", "adhesion_radius load approach status")
SpherePullOff = namedtuple("SpherePullOff", "load approach contact_radius status")
StripContact = namedtuple("StripContact", "penetration friction width shift status")
StripContactAtPenetration = namedtuple("StripContactAtPenetration", "load friction width shift status")


def sphere_scales(radius, contact_modulus, work_of_adhesion):
    """Units of the reduced variables of a sphere (Johnson 1997, eq. 2.11).

    From the radius [m], the contact modulus E* [Pa] and the work of adhesion [J/m^2], all above 0: the units of radii in the plane
    of contact [m], of the approach [m], of loads [N] and of stresses [Pa]. The adhesion stress in that unit is Maugis's lambda.
    """
    found = call(library.adfric_sphere_scales, "sphere_scales", (radius, contact_modulus, work_of_adhesion), (), 4, False)
    return Scales(*found)


def sphere_load(maugis_parameter, load, *, is_unstable=False):
    """Adhesive sphere by Maugis's theory with Dugdale's law, under a load; tension is negative. `is_unstable`: of two states the one
    that is not stable."""
    return SphereContact(*call(library.adfric_sphere_load, "sphere_load", (maugis_parameter, load), (is_unstable,), 3))


def sphere_approach(maugis_parameter, approach, *, is_unstable=False):
    """The same at an approach; separation is negative."""
    return SphereContactAtApproach(*call(library.adfric_sphere_approach, "sphere_approach", (maugis_parameter, approach),
                                         (is_unstable,), 3))


def sphere_radius(maugis_parameter, contact_radius):
    """The same for a radius of intimate contact, >= 0."""
    return SphereContactOfRadius(*call(library.adfric_sphere_radius, "sphere_radius", (maugis_parameter, contact_radius), (), 3))


def sphere_pull_off(maugis_parameter, *, holds_approach=False):
    """Where a contact that is pulled ends: the least load, or with `holds_approach` the least approach, that has a stable contact."""
    return SpherePullOff(*call(library.adfric_sphere_pull_off, "sphere_pull_off", (maugis_parameter,), (holds_approach,), 3))


def strip_load(phase, ratio, stress, reach, load, *, is_instantaneous=False, is_approach=False):
    """Rigid wavy strip that slides on a viscoelastic foundation and adheres to it (Goryacheva, Makhovskaya 2011), under a load.

    Lengths along the surface are in periods l, heights and penetrations in the height h of the wave, stresses in h times the
    stiffness of the foundation, friction in that times h/l. phase: 2 pi V Ts/l; ratio: Te/Ts, >= 1; stress: adhesion stress, 0: no
    adhesion; reach: range of adhesion.
    """
    return StripContact(*call(library.adfric_strip_load, "strip_load", (phase, ratio, stress, reach, load),
                              (is_instantaneous, is_approach), 4))


def strip_penetration(phase, ratio, stress, reach, penetration, *, is_instantaneous=False, is_approach=False):
    """The same at a penetration."""
    return StripContactAtPenetration(*call(library.adfric_strip_penetration, "strip_penetration",
                                           (phase, ratio, stress, reach, penetration), (is_instantaneous, is_approach), 4))


def call(function, name, given, flags, n_found, has_status=True):
    """Call the library with arrays of one shape: numbers, flags, and room for what is found."""
    try:
        given = [np.asarray(one, dtype=np.float64) for one in given]
        flags = [np.asarray(one, dtype=np.bool_) for one in flags]
    except (TypeError, ValueError) as problem:
        raise InputError(f"{name}: {problem}") from None
    shape = given[0].shape
    if any(one.shape != shape for one in (*given, *flags)):
        try:
            shape = np.broadcast_shapes(*(one.shape for one in (*given, *flags)))
        except ValueError:
            shapes = ", ".join(str(one.shape) for one in (*given, *flags))
            raise InputError(f"{name}: the shapes {shapes} do not go together") from None
        given = [np.broadcast_to(one, shape) for one in given]
        flags = [np.broadcast_to(one, shape) for one in flags]
    given = [np.ascontiguousarray(one) for one in given]
    flags = [np.ascontiguousarray(one) for one in flags]
    found = [np.empty(shape) for _ in range(n_found)]
    if has_status:
        found.append(np.empty(shape, dtype=np.int32))
    n = found[0].size
    if n > 0:
        function(n, *(one.ctypes.data for one in (*given, *flags, *found)))
    return [one[()] for one in found]
