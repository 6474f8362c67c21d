
#include <math.h>

/* A joint: sine and cosine of its angle, or its displacement as the sine. */
typedef struct { double sine, cosine; int is_singular; } found;
typedef struct { found both[2]; int count; } roots;
typedef struct { double x, y, z; int is_singular; } direction_of;

/* Angles closer than this cannot be told apart; a pose is reached that is missed by less than the second number, and a rotation
   has unit vectors at right angles to the third. */
#define APART 1e-7
#define REACHED 1e-9
#define ROTATION 1e-6
#define HALF_TURN 3.141592653589793

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

/* a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as size; the discriminant is
   a^2 + b^2 - c^2. */
static inline roots turns(double a, double b, double c, double discriminant, double size)
{
    const double square = a * a + b * b, least = roundings(1);
    roots all = {{{0, 1, 1}, {0, 1, 1}}, 0};
    size += square;
    if (square <= least * least * size) {
        all.count = c * c <= least * least * size && isfinite(size);
    } else if (discriminant > least * least * square) {
        const double root = sqrt(discriminant), scale = 1 / square;
        const int is_singular = 4 * discriminant <= APART * APART * square;
        all.both[0] = turned((b * c + a * root) * scale, (a * c - b * root) * scale, is_singular);
        all.both[1] = turned((b * c - a * root) * scale, (a * c + b * root) * scale, is_singular);
        all.count = 2;
    } else if (discriminant >= -roundings(size) && isfinite(size)) {
        const double scale = c < 0 ? -sqrt(square) : sqrt(square);
        all.both[0] = turned(b / scale, a / scale, 1);
        all.count = 1;
    }
    return all;
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

static inline double product(const double pose[4][4], int i, int j)
{
    return pose[0][i] * pose[0][j] + pose[1][i] * pose[1][j] + pose[2][i] * pose[2][j];
}

/* Whether a matrix is a pose. Two columns of its rotation have length one and are at right angles, and their vector product
   is the third. The last row is 0, 0, 0, 1, which a transposed pose has as its last column. */
static inline int is_pose(const double pose[4][4])
{
    int is_one = fabs(product(pose, 0, 0) - 1) <= ROTATION && fabs(product(pose, 1, 1) - 1) <= ROTATION
                 && fabs(product(pose, 0, 1)) <= ROTATION;
    for (int i = 0; i < 4; ++i) is_one = is_one && fabs(pose[3][i] - (i == 3)) <= ROTATION;
    for (int i = 0, j = 1, k = 2; i < 3; j = k, k = i++) {
        const double third = pose[j][0] * pose[k][1] - pose[k][0] * pose[j][1];
        is_one = is_one && fabs(third - pose[i][2]) <= ROTATION;
    }
    return is_one;
}

/* Writes a solution, unless it is not finite, and returns how many were written. */
static inline int keep(const found *joints, const int *turning, int count, int is_any, double *q, int *is_singular)
{
    *is_singular = is_any;
    for (int i = 0; i < count; ++i) {
        q[i] = turning[i] ? atan2(joints[i].sine, joints[i].cosine) : joints[i].sine;
        if (turning[i] && q[i] <= -HALF_TURN) q[i] = HALF_TURN;
        *is_singular = *is_singular || joints[i].is_singular;
        if (!isfinite(q[i])) return 0;
    }
    return 1;
}

/* A file need not need all of these. */
static inline void are_used(void)
{
    (void)turn; (void)turns; (void)slide; (void)slides; (void)direction; (void)is_reached; (void)is_pose; (void)keep;
    (void)are_used;
}
