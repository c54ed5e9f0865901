"""The human figure as an implicit solid: y up, facing +z, arms along x, feet on y = 0."""

from __future__ import annotations

from assets.generator.implicit import Field, chain, cone, cut, ellipsoid, loft, mirrored, union

X, Y, Z = 0, 1, 2
SHOULDER, ELBOW, WRIST = 0.175, 0.465, 0.755
ARM_HEIGHT, ARM_DEPTH = 1.425, -0.006

# Rows: place along the axis, centre (2), half widths (2).
TORSO = [
    [0.86, 0, -0.008, 0.070, 0.060],
    [0.91, 0, -0.010, 0.130, 0.086],
    [0.97, 0, -0.008, 0.152, 0.099],
    [1.04, 0, -0.002, 0.138, 0.091],
    [1.12, 0, 0.002, 0.122, 0.082],
    [1.22, 0, 0.004, 0.137, 0.094],
    [1.32, 0, 0.004, 0.158, 0.107],
    [1.40, 0, -0.003, 0.162, 0.099],
    [1.45, 0, -0.011, 0.138, 0.079],
    [1.49, 0, -0.017, 0.086, 0.058],
]
NECK = [
    [1.46, 0, -0.020, 0.060, 0.056],
    [1.54, 0, -0.012, 0.047, 0.048],
    [1.63, 0, 0.000, 0.047, 0.050],
]
LEG = [
    [0.085, 0.112, -0.022, 0.032, 0.037],
    [0.15, 0.111, -0.024, 0.033, 0.040],
    [0.33, 0.109, -0.022, 0.055, 0.060],
    [0.43, 0.106, -0.007, 0.049, 0.053],
    [0.50, 0.104, 0.001, 0.051, 0.056],
    [0.62, 0.100, 0.003, 0.067, 0.074],
    [0.76, 0.093, 0.002, 0.080, 0.090],
    [0.87, 0.088, -0.003, 0.081, 0.093],
    [0.97, 0.068, -0.006, 0.056, 0.070],
]
ARM = [
    [0.150, ARM_DEPTH, ARM_HEIGHT - 0.006, 0.056, 0.056],
    [0.215, ARM_DEPTH, ARM_HEIGHT - 0.002, 0.058, 0.061],
    [0.300, ARM_DEPTH, ARM_HEIGHT, 0.051, 0.051],
    [0.390, ARM_DEPTH, ARM_HEIGHT, 0.048, 0.048],
    [ELBOW, ARM_DEPTH, ARM_HEIGHT, 0.044, 0.044],
    [0.540, ARM_DEPTH, ARM_HEIGHT, 0.046, 0.046],
    [0.660, ARM_DEPTH, ARM_HEIGHT, 0.037, 0.036],
    [WRIST, ARM_DEPTH, ARM_HEIGHT, 0.031, 0.027],
]
PALM = [
    [0.755, ARM_DEPTH, ARM_HEIGHT, 0.030, 0.026],
    [0.790, -0.004, ARM_HEIGHT, 0.041, 0.024],
    [0.830, -0.002, ARM_HEIGHT, 0.049, 0.021],
    [0.855, -0.002, ARM_HEIGHT, 0.049, 0.017],
]
# Fingers from index to little: z at the knuckle, z at the tip, x of the tip.
FINGERS = [
    (0.040, 0.056, 0.936),
    (0.0125, 0.018, 0.955),
    (-0.0155, -0.022, 0.946),
    (-0.042, -0.064, 0.917),
]


def hand() -> Field:
    """The hand at the end of the +x arm: palm down, thumb forward, fingers a little spread."""
    y = ARM_HEIGHT
    fingers = []
    for z0, z1, tip in FINGERS:
        knuckle = (0.835, y + 0.001, z0)
        middle = ((0.835 + tip) / 2, y + 0.002, (z0 + z1) / 2)
        fingers.append(
            chain(0.006, (knuckle, middle, (tip, y - 0.004, z1)), (0.013, 0.012, 0.0102))
        )
    thumb = chain(
        0.01,
        ((0.785, y - 0.004, 0.022), (0.815, y - 0.010, 0.058), (0.866, y - 0.012, 0.084)),
        (0.019, 0.015, 0.0115),
    )
    return union(0.016, union(0.005, *fingers), union(0.02, loft(X, Z, Y, PALM), thumb))


def arm() -> Field:
    """Shoulder to finger tips along +x."""
    return union(0.03, loft(X, Z, Y, ARM), hand())


def head() -> Field:
    """Skull, jaw, nose, eyes in their hollows, lips and ears."""
    skull = ellipsoid((0, 1.706, -0.010), (0.077, 0.096, 0.099))
    jaw = union(
        0.04,
        ellipsoid((0, 1.655, 0.019), (0.059, 0.066, 0.060)),
        ellipsoid((0, 1.600, 0.053), (0.026, 0.020, 0.027)),
    )
    mask = cut(
        0.03,
        union(0.05, skull, jaw),
        mirrored(ellipsoid((0.033, 1.690, 0.093), (0.023, 0.015, 0.022)), 0.01),
    )
    nose = union(
        0.012,
        cone((0, 1.700, 0.080), (0, 1.661, 0.099), 0.007, 0.0105),
        mirrored(ellipsoid((0.008, 1.657, 0.089), (0.0085, 0.008, 0.010)), 0.01),
    )
    eyes = mirrored(ellipsoid((0.031, 1.688, 0.0645), (0.0150, 0.011, 0.012)), 0.01)
    lips = ellipsoid((0, 1.6200, 0.0695), (0.023, 0.0095, 0.014))
    ears = mirrored(ellipsoid((0.075, 1.683, -0.012), (0.013, 0.027, 0.018)), 0.01)
    return union(0.010, union(0.018, mask, nose), eyes, lips, ears)


def foot() -> Field:
    """Heel to toes of the +x leg; the sole is flattened by `body`."""
    return union(
        0.03,
        ellipsoid((0.113, 0.036, -0.042), (0.038, 0.044, 0.044)),
        cone((0.113, 0.060, -0.012), (0.121, 0.032, 0.085), 0.043, 0.034),
        ellipsoid((0.122, 0.024, 0.105), (0.046, 0.030, 0.066)),
    )


def body() -> Field:
    """The whole figure."""
    neck = loft(Y, X, Z, NECK)
    trapezius = mirrored(cone((0.02, 1.503, -0.024), (0.150, 1.450, -0.012), 0.028, 0.030), 0.02)
    chest = mirrored(ellipsoid((0.070, 1.345, 0.062), (0.080, 0.062, 0.040)), 0.03)
    seat = mirrored(ellipsoid((0.068, 0.918, -0.048), (0.078, 0.080, 0.066)), 0.03)
    trunk = union(0.07, loft(Y, X, Z, TORSO), trapezius, chest, seat)
    trunk = union(0.04, trunk, neck)
    legs = mirrored(union(0.03, loft(Y, X, Z, LEG), foot()), 0.04)
    whole = union(0.03, union(0.06, union(0.08, trunk, legs), mirrored(arm(), 0.01)), head())
    return cut(0.016, whole, lambda p: p[:, Y])
