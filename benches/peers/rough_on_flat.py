"""The surface of the case rough_on_flat made anew, and pressed by ContactMechanics: python3 benches/peers/rough_on_flat.py.

Prints the rms height of the surface and, at three mean pressures, the largest pressure and the area of the elements in contact: the
values of its expected.toml. Then what is pressed in of a surface that yields under 1 GPa: the values of the test
`a_rough_surface_yields_as_in_another_program`.
"""

import numpy as np
from ContactMechanics import PeriodicFFTElasticHalfSpace
from ContactMechanics.PlasticSystemSpecialisations import PlasticNonSmoothContactSystem
from ContactMechanics.Systems import NonSmoothContactSystem
from SurfaceTopography import PlasticTopography, Topography

PERIOD, SHORT, LONG = 0.512e-3, 16e-6, 0.128e-3
SLOPE, HURST, SEED = 0.01, 0.8, 1
POINTS = 256
MODULUS = 210e9 / (2 * (1 - 0.3**2))
HARDNESS = 1e9


def random(index):
    """The number of that index of SplitMix64 (Steele, Lea and Flood 2014), from 0 to 1."""
    mixed = (SEED + index * 0x9E3779B97F4A7C15) % 2**64
    mixed = (mixed ^ mixed >> 30) * 0xBF58476D1CE4E5B9 % 2**64
    mixed = (mixed ^ mixed >> 27) * 0x94D049BB133111EB % 2**64
    return ((mixed ^ mixed >> 31) >> 11) / 2**53


def heights():
    """Heights (m), y first: the sum of all waves, one after the other."""
    phase = 2 * np.pi * np.arange(POINTS) / POINTS
    shortest, longest = PERIOD / SHORT, PERIOD / LONG
    reach = int(shortest)
    surface, slopes = np.zeros((POINTS, POINTS)), 0.0
    for ky in range(reach + 1):
        row = np.zeros(POINTS, complex)
        for kx in range(-reach if ky else 1, reach + 1):
            waves = np.hypot(kx, ky)
            if waves <= shortest:
                amplitude = max(waves, longest) ** (-1 - HURST)
                turn = 2 * np.pi * random((ky << 32) | (kx & 0xFFFFFFFF))
                row += amplitude * np.exp(1j * (turn + kx * phase))
                slopes += 0.5 * (amplitude * waves * 2 * np.pi / PERIOD) ** 2
        surface += np.outer(np.exp(1j * ky * phase), row).real
    return surface * SLOPE / np.sqrt(slopes)


def main():
    """Print the values."""
    surface = heights()
    print(f"Sq {surface.std():.9e} m")
    size = (PERIOD, PERIOD)
    half_space = PeriodicFFTElasticHalfSpace((POINTS, POINTS), MODULUS, size)
    system = NonSmoothContactSystem(half_space, Topography(surface.T, size, periodic=True))
    element = (PERIOD / POINTS) ** 2
    for mean in (4e6, 20e6, 40e6):
        found = system.minimize_proxy(external_force=mean * PERIOD**2, pentol=1e-13)
        pressure = np.asarray(half_space.force) / element
        touching = (pressure > 0).sum() * element
        print(
            f"{mean / 1e6:g} MPa: {found.success}, peak {pressure.max() / 1e6:.4f} MPa, {touching * 1e6:.6f} mm^2"
        )
    half_space = PeriodicFFTElasticHalfSpace((POINTS, POINTS), MODULUS, size)
    soft = PlasticTopography(Topography(surface.T, size, periodic=True), HARDNESS)
    system = PlasticNonSmoothContactSystem(half_space, soft)
    found = system.minimize_proxy(external_force=40e6 * PERIOD**2, pentol=1e-13)
    imprint = -np.asarray(soft.plastic_displ)
    print(f"yielding, 40 MPa: {found.success}, imprint {imprint.max() * 1e6:.8f} um, {imprint.sum() * element:.7e} m^3")


if __name__ == "__main__":
    main()
