
#include <math.h>

/* A joint: sine and cosine of its angle, or its displacement as the sine. An angle is known to rounding * sqrt(size / length),
   half a turn at most. Roots say how far an equation without any is from having one. */
typedef struct { double sine, cosine; int is_singular; double length, size; } found;
typedef struct { found both[2]; int count; double miss; } roots;
typedef struct { double x, y, z; int is_singular; } direction_of;

/* Angles closer than this cannot be told apart; a pose is reached that is missed by less than the second number, a last row is
   0, 0, 0, 1 to the third and a rotation one to the fourth. */
#define APART 1e-7
#define REACHED 1e-9
#define LAST_ROW 1e-6
#define ROTATION 1e-3
#define HALF_TURN 3.141592653589793

/* Differences of numbers as large as the size may be nothing but rounding below this. */
static inline double roundings(double size) { return 16 * 2.220446049250313e-16 * size; }

static inline found turned(double sine, double cosine, int is_singular, double length, double size)
{
    const found one = {sine, cosine, is_singular, length, size};
    return one;
}

/* The turn with this cosine and sine times a length; zero if that vanishes beside size. Of a folded arm the length itself has no
   digits left, and the cosine and the sine have. */
static inline found turn(double cosine, double sine, double length, double size)
{
    const double least = roundings(1);
    (void)length;
    length = sqrt(cosine * cosine + sine * sine);
    if (length <= least * least * size || length <= 0) return turned(0, 1, 1, 0, 1);
    const double scale = 1 / length;
    return turned(sine * scale, cosine * scale, length <= APART * APART * size, length, size);
}

static inline found slide(double position) { return turned(position, 0, 0, 0, 1); }

/* The length of a double root: a step d from a root changes a cos q + b sin q by root d + radius d^2 / 2. */
static inline double length_of(double square, double size) { return 0.5 * roundings(sqrt(square * size)); }

/* a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as size; the discriminant is
   a^2 + b^2 - c^2. */
static inline roots turns(double a, double b, double c, double discriminant, double size)
{
    const double square = a * a + b * b, least = roundings(1);
    /* A discriminant that is nothing but rounding is none: later joints then see the same root as this one. */
    const double noise = 0.25 * least * least * size * square;
    const found any = turned(0, 1, 1, 0, 1);
    roots all = {{any, any}, 0, 0};
    size += square;
    if (square <= least * least * size) {
        all.count = c * c <= least * least * size && isfinite(size);
        all.miss = -(c * c / size);
    } else if (discriminant > least * least * square && discriminant * discriminant > noise) {
        const double root = sqrt(discriminant), scale = 1 / square;
        const int is_singular = 4 * discriminant <= APART * APART * square || square <= APART * APART * size;
        const double known = is_singular ? fmax(discriminant, length_of(square, size)) : discriminant;
        all.both[0] = turned((b * c + a * root) * scale, (a * c - b * root) * scale, is_singular, known, size);
        all.both[1] = turned((b * c - a * root) * scale, (a * c + b * root) * scale, is_singular, known, size);
        all.count = 2;
    } else {
        const double scale = c < 0 ? -sqrt(square) : sqrt(square);
        all.both[0] = turned(b / scale, a / scale, 1, length_of(square, size), size);
        all.count = discriminant >= -roundings(size) && isfinite(size);
        all.miss = discriminant / size;
    }
    return all;
}

/* b + root and b - root of the discriminant, a difference of numbers as large as size. */
static inline roots slides(double b, double discriminant, double size)
{
    const double root = discriminant > 0 ? sqrt(discriminant) : 0;
    const int is_singular = 4 * root * root <= APART * APART * size;
    const int is_some = discriminant >= -roundings(size) && isfinite(size);
    roots all = {{{b + root, 0, is_singular, 0, 1}, {b - root, 0, is_singular, 0, 1}}, 0, discriminant / size};
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

/* Farther away than any equation is. */
#define NO_TRY (-1e30)

/* Roots as they are; if there is none, the least of how far equations are from having one is noted. */
static inline roots noted(roots all, double *miss)
{
    if (all.count == 0 && all.miss > *miss) *miss = all.miss;
    return all;
}

/* A joint that a pose leaves free, entirely or as far as rounding goes. If the equations of later joints have no solution with what
   was found, the nearest position is taken with which they have one. Positions are tried on a grid on either side. Where the
   equations fail least, three tries enclose a maximum, which is narrowed. From a try that is solved the way back to the first one
   that is solved is halved. */
enum { GRID_SIZE = 32, ROUNDS = 60 };
typedef enum { AS_FOUND, TRIED, GRID, NARROW, HALVE, LAST, OVER } phase_of;
typedef struct { double at, miss; } try_of;
typedef struct {
    found joint, first;
    phase_of phase;
    /* How many solutions there were; the number of the try on this side; rounds that are left. */
    int before, number, rounds;
    double side, step, at;
    try_of grid[3], around[3];
    /* The end that is not solved, and the one that is; the nearest that is solved, with its sign. */
    double ends[2], nearest;
    /* How nearly the best was solved, here and before. */
    double best, outer;
} family;

/* A search sets what else there is. */
static inline family family_of(found joint)
{
    family one;
    one.joint = one.first = joint;
    one.phase = AS_FOUND;
    return one;
}

/* Whether no position that leads to the pose has a solution, if the one that was found has none. */
static inline int is_far(const family *one, double miss)
{
    const double steep = roundings(8);
    return miss <= NO_TRY || !(miss * miss * one->first.length <= steep * steep * one->first.size);
}

static inline void halve(family *one, double outside, double inside)
{
    one->ends[0] = outside;
    one->ends[1] = inside;
    one->phase = HALVE;
    one->rounds = ROUNDS;
}

/* Takes in a try on the grid. */
static inline void on_grid(family *one, double miss, int is_solved)
{
    try_of *grid = one->grid;
    if (is_solved && one->number > 0) {
        halve(one, grid[2].at, one->at);
        return;
    }
    grid[0] = grid[1];
    grid[1] = grid[2];
    grid[2].at = one->at;
    /* A solution on the other side of what was found: its own turn comes. */
    grid[2].miss = is_solved ? 1 : miss;
    if (one->number > 0 && grid[1].miss > grid[0].miss && grid[1].miss >= grid[2].miss) {
        for (int i = 0; i < 3; ++i) one->around[i] = grid[i];
        one->phase = NARROW;
        one->rounds = ROUNDS;
    } else {
        ++one->number;
    }
}

/* Takes in a try beside the best of three. */
static inline void in_between(family *one, double miss, int is_solved)
{
    try_of *around = one->around;
    const try_of now = {one->at, miss};
    const int is_before = now.at < around[1].at, is_better = miss >= around[1].miss;
    if (is_solved) {
        halve(one, fmax(around[0].at, 0), one->at);
        return;
    }
    if (is_better) {
        around[is_before ? 2 : 0] = around[1];
        around[1] = now;
    } else {
        around[is_before ? 0 : 2] = now;
    }
    if (--one->rounds == 0) {
        one->phase = GRID;
        ++one->number;
    }
}

/* Behind the grid and behind the first that is solved: to the other side, and behind both to the nearest that is solved. */
static inline void turn_round(family *one)
{
    if (one->side > 0) {
        one->side = -1;
        one->number = -1;
        one->phase = GRID;
    } else {
        one->phase = isfinite(one->nearest) ? LAST : OVER;
        one->side = 1;
        one->at = one->nearest;
    }
}

/* Chooses the place of the next try. */
static inline void choose(family *one)
{
    if (one->phase == HALVE && one->rounds == 0) {
        if (fabs(one->ends[1]) < fabs(one->nearest)) one->nearest = one->ends[1] * one->side;
        turn_round(one);
    } else if (one->phase == GRID && one->number > GRID_SIZE) {
        turn_round(one);
    }
    if (one->phase == GRID) one->at = one->step * one->number;
    if (one->phase == HALVE) one->at = 0.5 * (one->ends[0] + one->ends[1]);
    if (one->phase == NARROW) {
        const try_of *around = one->around;
        const int is_before = around[1].at - around[0].at > around[2].at - around[1].at;
        one->at = 0.5 * (around[1].at + around[is_before ? 0 : 2].at);
    }
}

/* Begins the search, within half the range of positions that lead to the pose. */
static inline void begin(family *one, double miss)
{
    const try_of none = {0, 0};
    for (int i = 0; i < 3; ++i) one->grid[i] = one->around[i] = none;
    one->step = fmin(roundings(sqrt(one->first.size / one->first.length)), HALF_TURN) / GRID_SIZE;
    one->phase = GRID;
    one->number = -1;
    one->side = 1;
    one->nearest = HUGE_VAL;
    one->best = miss;
    choose(one);
}

/* Reads what the last try has found, and chooses the next one. */
static inline void search(family *one, double miss, int is_solved)
{
    one->best = fmax(one->best, miss);
    if (one->phase == GRID) on_grid(one, miss, is_solved);
    else if (one->phase == NARROW) in_between(one, miss, is_solved);
    else {
        one->ends[is_solved] = one->at;
        --one->rounds;
    }
    choose(one);
}

/* The next position to be tried, if there is one, as the joint. Behind a try count and miss say what was found; solutions of all
   but the last are taken away again. */
static inline int next(family *one, int *count, double *miss)
{
    const double here = *miss;
    *miss = NO_TRY;
    if (one->phase == AS_FOUND) {
        one->phase = TRIED;
        one->before = *count;
        one->outer = here;
        return 1;
    }
    const int is_solved = *count > one->before;
    if (one->phase == TRIED && (is_solved || is_far(one, here))) {
        *miss = fmax(here, one->outer);
        return 0;
    }
    if (one->phase == TRIED) begin(one, here);
    else if (one->phase == LAST) one->phase = OVER;
    else {
        *count = one->before;
        search(one, here, is_solved);
    }
    if (one->phase == OVER) {
        *miss = fmax(one->best, one->outer);
        return 0;
    }
    const double s = sin(one->at * one->side), c = cos(one->at * one->side);
    const found first = one->first;
    one->joint = turned(first.sine * c + first.cosine * s, first.cosine * c - first.sine * s, 1, 0, 1);
    return 1;
}

/* Writes R'R - 1 and returns 1 if R is nearly orthogonal, 2 if it is but for rounding, else 0. */
static inline int orthogonal(const double pose[4][4], double miss[3][3])
{
    int is_nearly = 1, is_exact = 1;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
            const double m = pose[0][i] * pose[0][j] + pose[1][i] * pose[1][j] + pose[2][i] * pose[2][j] - (i == j);
            miss[i][j] = miss[j][i] = m;
            is_nearly = is_nearly && fabs(m) <= ROTATION;
            is_exact = is_exact && fabs(m) <= roundings(4);
        }
    }
    return is_nearly + is_exact;
}

/* Copies a pose and returns whether it is one: its position is finite and, where more is read, its last row 0, 0, 0, 1, which a
   transposed pose has as its last column, and its rotation one to 1e-3. The copy has the nearest rotation, the orthogonal part
   of a polar decomposition, by R <- R (3 - R'R) / 2. */
static inline int nearest_pose(const double pose[4][4], int reads_rotation, double at[4][4])
{
    double miss[3][3], volume = 0;
    int is_one = isfinite(pose[0][3]) && isfinite(pose[1][3]) && isfinite(pose[2][3]);
    for (int i = 0; i < 16; ++i) at[i / 4][i % 4] = pose[i / 4][i % 4];
    if (!reads_rotation) return is_one;
    for (int i = 0; i < 4; ++i) is_one = is_one && fabs(pose[3][i] - (i == 3)) <= LAST_ROW;
    for (int i = 0, j = 1, k = 2; i < 3; j = k, k = i++) {
        volume += pose[i][0] * (pose[j][1] * pose[k][2] - pose[k][1] * pose[j][2]);
    }
    int how = orthogonal(pose, miss);
    if (!(is_one && volume > 0 && how)) return 0;
    for (int rounds = 0; rounds < 3 && how < 2; ++rounds, how = orthogonal((const double(*)[4])at, miss)) {
        for (int i = 0; i < 3; ++i) {
            const double row[3] = {at[i][0], at[i][1], at[i][2]};
            for (int j = 0; j < 3; ++j) {
                at[i][j] -= 0.5 * (row[0] * miss[0][j] + row[1] * miss[1][j] + row[2] * miss[2][j]);
            }
        }
    }
    return 1;
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
    (void)turn; (void)turns; (void)slide; (void)slides; (void)direction; (void)is_reached; (void)nearest_pose; (void)keep;
    (void)noted; (void)family_of; (void)next;
    (void)are_used;
}
