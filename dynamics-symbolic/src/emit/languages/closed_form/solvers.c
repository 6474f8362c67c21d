
#include <math.h>

/* A joint: sine and cosine of its angle, or its displacement as the sine. */
typedef struct { double sine, cosine; int is_singular; } found;
typedef struct { found both[2]; int count; } roots;
typedef struct { double x, y, z; int is_singular; } direction_of;

/* Angles closer than this cannot be told apart; a pose is reached that is missed by less than the second number. */
#define APART 1e-7
#define REACHED 1e-9

/* Differences of numbers as large as the size may be nothing but rounding below this. */
static inline double roundings(double size) { return 16 * 2.220446049250313e-16 * size; }

static inline found turned(double sine, double cosine, int is_singular)
{
    const found one = {sine, cosine, is_singular};
    return one;
}

/* The turn with this cosine and sine times length; zero if that vanishes beside size. */
static inline found turn(double cosine, double sine, double length, double size)
{
    const double squares = cosine * cosine + sine * sine, least = roundings(1);
    if (length <= least * least * size || squares <= 0) return turned(0, 1, 1);
    const double scale = 1 / sqrt(squares);
    return turned(sine * scale, cosine * scale, length <= APART * APART * size);
}

static inline found slide(double position) { return turned(position, 0, 0); }

static inline roots by_discriminant(double a, double b, double c, double square, double discriminant, double size)
{
    const double radius = sqrt(square);
    roots all = {{{0, 1, 1}, {0, 1, 1}}, 0};
    if (discriminant > 0) {
        const double root = sqrt(discriminant), scale = 1 / square;
        const int is_singular = root + root <= APART * radius;
        all.both[0] = turned((b * c + a * root) * scale, (a * c - b * root) * scale, is_singular);
        all.both[1] = turned((b * c - a * root) * scale, (a * c + b * root) * scale, is_singular);
        all.count = 2;
    } else if (discriminant >= -roundings(size) && isfinite(size)) {
        const double scale = c < 0 ? -radius : radius;
        all.both[0] = turned(b / scale, a / scale, 1);
        all.count = 1;
    }
    return all;
}

/* a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as size. */
static inline roots turns(double a, double b, double c, double size)
{
    const double square = a * a + b * b, least = roundings(1), radius = sqrt(square), magnitude = fabs(c);
    size += square;
    if (square <= least * least * size) {
        const roots any = {{{0, 1, 1}, {0, 1, 1}}, c * c <= least * least * size && isfinite(size)};
        return any;
    }
    return by_discriminant(a, b, c, square, (radius - magnitude) * (radius + magnitude), size);
}

/* |y - Rz(q) x|^2 + rest = found, which is a cos q + b sin q = (known - found) / 2, with a step of Newton's method. */
static inline roots turns_at_distance(double a, double b, double known, double distance, double x0, double x1, double y0,
                                      double y1, double rest)
{
    const double c = (known - distance) * 0.5;
    roots all = turns(a, b, c, (known + distance) * (known + distance));
    for (int k = 0; k < all.count; ++k) {
        found *one = &all.both[k];
        if (one->is_singular) continue;
        const double s = one->sine, u = one->cosine * x0 - s * x1, v = s * x0 + one->cosine * x1;
        const double du = u - y0, dv = v - y1;
        const double step = (distance - rest - (du * du + dv * dv)) / (-2 * (u * y1 - v * y0));
        one->sine = s + one->cosine * step;
        one->cosine -= s * step;
    }
    return all;
}

/* The same with a^2 + b^2 - c^2. */
static inline roots turns_by(double a, double b, double c, double discriminant)
{
    const double square = a * a + b * b, least = roundings(sqrt(square));
    const int is_nothing = discriminant <= least * least && discriminant >= -roundings(square);
    return by_discriminant(a, b, c, square, is_nothing ? 0 : discriminant, square);
}

/* The same with (1 - along) (1 + along - twice), where (1 - along) (1 + along) = across. */
static inline roots inclined_turns(double a, double b, double c, double along, double across, double twice)
{
    return turns_by(a, b, c, across / (1 + along) * (1 + along - twice));
}

/* b + root and b - root of the discriminant, a difference of numbers as large as size. */
static inline roots slides(double b, double discriminant, double size)
{
    const double root = discriminant > 0 ? sqrt(discriminant) : 0;
    const int is_singular = 4 * root * root <= APART * APART * size;
    const int is_some = discriminant >= -roundings(size) && isfinite(size);
    roots all = {{{b + root, 0, is_singular}, {b - root, 0, is_singular}}, 0};
    all.count = is_some ? (discriminant > 0 ? 2 : 1) : 0;
    return all;
}

static inline double root(double square) { return sqrt(square); }

/* The direction of a vector, or of the other one if the first vanishes beside size. */
static inline direction_of direction(double x, double y, double z, double u, double v, double w, double size)
{
    const double square = x * x + y * y + z * z, least = roundings(1);
    if (!(square > least * least * size)) { x = u; y = v; z = w; }
    const double scale = 1 / sqrt(x * x + y * y + z * z);
    const direction_of one = {x * scale, y * scale, z * scale, square <= APART * APART * size};
    return one;
}

static inline int is_reached(double x, double y, double z, double size)
{
    return x * x + y * y + z * z <= REACHED * REACHED * size && isfinite(size);
}

/* Writes a solution, unless it is not finite, and returns how many were written. */
static inline int keep(const found *joints, const int *turning, int count, int is_any, double *q, int *is_singular)
{
    *is_singular = is_any;
    for (int i = 0; i < count; ++i) {
        q[i] = turning[i] ? atan2(joints[i].sine + 0.0, joints[i].cosine) : joints[i].sine;
        *is_singular = *is_singular || joints[i].is_singular;
        if (!isfinite(q[i])) return 0;
    }
    return 1;
}

/* A file need not need all of these. */
static inline void are_used(void)
{
    (void)turn; (void)slide; (void)turns_at_distance; (void)turns_by; (void)inclined_turns; (void)slides;
    (void)root; (void)direction; (void)is_reached; (void)keep; (void)are_used;
}
