/* A joint: sine and cosine of its angle, and its position. Its displacement is the sine too. An angle is known to
   rounding * sqrt(size / length), half a turn at most. Roots say how far an equation without any is from having one. */
typedef struct { REAL sine, cosine, q; int is_singular, is_second; REAL length, size; } found;

typedef struct { found both[2]; int count; REAL miss; } roots;

typedef struct { REAL x, y, z; int is_singular; } direction_of;

/* Angles closer than APART cannot be told apart. A pose is reached that is missed by less than REACHED. A last row is 0, 0, 0, 1
   to LAST_ROW, and a rotation one to ROTATION. */
#define APART AS_APART

#define REACHED AS_REACHED

#define LAST_ROW AS_LAST_ROW

#define ROTATION 0.001

#define HALF_TURN 3.141592653589793

/* The largest number that is not infinite. */
#define LARGEST_NUMBER AS_LARGEST

/* Differences of numbers as large as the size may be nothing but rounding below this. */
static inline REAL roundings(REAL size) { return 16.0 * AS_EPSILON * size; }

static inline REAL size_of(REAL x) { return x > 0.0 ? x : 0.0 - x; }

static inline REAL largest(REAL a, REAL b) { return a > b ? a : b; }

static inline int is_finite(REAL x) { return size_of(x) <= LARGEST_NUMBER; }

/* The arc tangent z + z^3 P(z^2) for |z| <= tan(pi/8): -P of the square of z. */
ARC_TANGENT

/* The angle from -pi to pi with this sine and cosine, up to a common positive factor; 0 where both vanish. */
static inline REAL angle(REAL sine, REAL cosine)
{
    const REAL s = size_of(sine), c = size_of(cosine);
    const int is_steep = s > c;
    const REAL small = is_steep ? c : s, large = is_steep ? s : c;
    /* tan(x - pi/4) = (tan x - 1) / (tan x + 1) */
    const int is_far = small > 0.41421356237309504 * large;
    const REAL under = is_far ? small + large : large;
    const REAL z = (is_far ? small - large : small) / (under <= 0.0 ? 1.0 : under);
    const REAL square = z * z;
    REAL x = z - z * (square * arc_tangent(square));
    if (is_far) x = 0.7853981633974483 + x;
    if (is_steep) x = 1.5707963267948966 - x;
    if (cosine < 0.0) x = HALF_TURN - x;
    return sine < 0.0 ? -x : x;
}

/* A turn whose sine and cosine are these times a scale. An angle that rounding takes to -pi is half a turn all the same. */
static inline found turned(REAL sine, REAL cosine, REAL scale, int is_singular, REAL length, REAL size)
{
    const REAL q = angle(sine, cosine);
    const found one = {sine * scale, cosine * scale, q <= -HALF_TURN ? HALF_TURN : q, is_singular, 0, length, size};
    return one;
}

/* The turn with this cosine and sine times a length; zero if that vanishes beside size. Of a folded arm the length itself has no
   digits left, and the cosine and the sine have. */
static inline found turn(REAL cosine, REAL sine, REAL length, REAL size)
{
    const REAL least = roundings(1.0);
    (void)length;
    length = SQRT(cosine * cosine + sine * sine);
    if (length <= least * least * size || length <= 0.0) return turned(0.0, 1.0, 1.0, 1, 0.0, 1.0);
    return turned(sine, cosine, 1.0 / length, length <= APART * APART * size, length, size);
}

static inline found displaced(REAL position, int is_singular)
{
    const found one = {position, 0.0, position, is_singular, 0, 0.0, 1.0};
    return one;
}

static inline found slide(REAL position) { return displaced(position, 0); }

/* The length of a double root: a step d from a root changes a cos q + b sin q by root d + radius d^2 / 2. */
static inline REAL length_of(REAL square, REAL size) { return 0.5 * roundings(SQRT(square * size)); }

/* a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as size; the discriminant is
   a^2 + b^2 - c^2. */
static inline roots turns(REAL a, REAL b, REAL c, REAL discriminant, REAL size)
{
    const REAL square = a * a + b * b, least = roundings(1.0);
    /* A discriminant that is nothing but rounding is none: later joints then see the same root as this one. */
    const REAL noise = 0.25 * least * least * size * square;
    const found any = turned(0.0, 1.0, 1.0, 1, 0.0, 1.0);
    roots all = {{any, any}, 0, 0.0};
    size += square;
    if (square <= least * least * size) {
        all.count = c * c <= least * least * size && is_finite(size);
        all.miss = -(c * c / size);
    } else if (discriminant > least * least * square && discriminant * discriminant > noise) {
        const REAL root = SQRT(discriminant), scale = 1.0 / square;
        const int is_singular = 4.0 * discriminant <= APART * APART * square || square <= APART * APART * size;
        const REAL known = is_singular ? largest(discriminant, length_of(square, size)) : discriminant;
        all.both[0] = turned((b * c + a * root) * scale, (a * c - b * root) * scale, 1.0, is_singular, known, size);
        all.both[1] = turned((b * c - a * root) * scale, (a * c + b * root) * scale, 1.0, is_singular, known, size);
        all.both[1].is_second = 1;
        all.count = 2;
    } else {
        const REAL scale = c < 0.0 ? -SQRT(square) : SQRT(square);
        all.both[0] = turned(b / scale, a / scale, 1.0, 1, length_of(square, size), size);
        all.count = discriminant >= -roundings(size) && is_finite(size);
        all.miss = discriminant / size;
    }
    return all;
}

/* a cos q + b sin q = c of a point, and u cos q + v sin q = w of the direction of a line on which it is: the point that is farther
   along it by the root of size, where the discriminant is larger, meets their sum. */
static inline roots turns_of_line(REAL a, REAL b, REAL c, REAL u, REAL v, REAL w, REAL size)
{
    const REAL along = a * u + b * v < c * w ? -SQRT(size) : SQRT(size);
    const REAL x = a + along * u, y = b + along * v, z = c + along * w;
    return turns(x, y, z, x * x + y * y - z * z, size);
}

/* b + root and b - root of the discriminant, a difference of numbers as large as size. */
static inline roots slides(REAL b, REAL discriminant, REAL size)
{
    const REAL root = discriminant > 0.0 ? SQRT(discriminant) : 0.0;
    const int is_singular = 4.0 * root * root <= APART * APART * size;
    const int is_some = discriminant >= -roundings(size) && is_finite(size);
    roots all = {{displaced(b + root, is_singular), displaced(b - root, is_singular)}, 0, discriminant / size};
    all.both[1].is_second = 1;
    all.count = is_some ? (discriminant > 0.0 ? 2 : 1) : 0;
    return all;
}

/* The direction of a vector, or of the other one if the first vanishes beside size. */
static inline direction_of direction(REAL x, REAL y, REAL z, REAL u, REAL v, REAL w, REAL size)
{
    const REAL square = x * x + y * y + z * z, least = roundings(1.0);
    const int is_other = !(square > least * least * size);
    const REAL a = is_other ? u : x, b = is_other ? v : y, c = is_other ? w : z;
    const REAL scale = 1.0 / SQRT(a * a + b * b + c * c);
    const direction_of one = {a * scale, b * scale, c * scale, square <= APART * APART * size};
    return one;
}

static inline int is_reached(REAL x, REAL y, REAL z, REAL size)
{
    return x * x + y * y + z * z <= REACHED * REACHED * size && is_finite(size);
}

/* Farther away than any equation is. */
#define NO_TRY (-1000000000000000000000000000000.0)

/* Roots as they are; if there is none, the least of how far equations are from having one is noted. */
static inline roots noted(roots all, REAL *miss)
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
typedef struct { REAL at, miss; } try_of;
typedef struct {
    found joint, first;
    phase_of phase;
    /* How many solutions there were; the number of the try on this side; rounds that are left. */
    int before, number, rounds;
    REAL side, step, at;
    try_of grid[3], around[3];
    /* The end that is not solved, and the one that is; the nearest that is solved, with its sign. */
    REAL ends[2], nearest;
    /* How nearly the best was solved, here and before. */
    REAL best, outer;
} family;

/* A search sets all else. */
static inline void family_of(family *one, found joint)
{
    one->joint = joint;
    one->first = joint;
    one->phase = AS_FOUND;
}

/* Whether no position that leads to the pose has a solution, if the one that was found has none. */
static inline int is_far(const family *one, REAL miss)
{
    const REAL steep = roundings(8.0);
    return miss <= NO_TRY || !(miss * miss * one->first.length <= steep * steep * one->first.size);
}

static inline void halve(family *one, REAL outside, REAL inside)
{
    one->ends[0] = outside;
    one->ends[1] = inside;
    one->phase = HALVE;
    one->rounds = ROUNDS;
}

/* Takes in a try on the grid. */
static inline void on_grid(family *one, REAL miss, int is_solved)
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
    grid[2].miss = is_solved ? 1.0 : miss;
    if (one->number > 0 && grid[1].miss > grid[0].miss && grid[1].miss >= grid[2].miss) {
        for (int i = 0; i < 3; ++i) one->around[i] = grid[i];
        one->phase = NARROW;
        one->rounds = ROUNDS;
    } else {
        ++one->number;
    }
}

/* Takes in a try beside the best of three. */
static inline void in_between(family *one, REAL miss, int is_solved)
{
    try_of *around = one->around;
    const try_of now = {one->at, miss};
    const int is_before = now.at < around[1].at, is_better = miss >= around[1].miss;
    if (is_solved) {
        halve(one, largest(around[0].at, 0.0), one->at);
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
    if (one->side > 0.0) {
        one->side = -1.0;
        one->number = -1;
        one->phase = GRID;
    } else {
        one->phase = one->nearest < LARGEST_NUMBER ? LAST : OVER;
        one->side = 1.0;
        one->at = one->nearest;
    }
}

/* Chooses the place of the next try. */
static inline void choose(family *one)
{
    if (one->phase == HALVE && one->rounds == 0) {
        if (size_of(one->ends[1]) < size_of(one->nearest)) one->nearest = one->ends[1] * one->side;
        turn_round(one);
    } else if (one->phase == GRID && one->number > GRID_SIZE) {
        turn_round(one);
    }
    if (one->phase == GRID) one->at = one->step * (REAL)one->number;
    if (one->phase == HALVE) one->at = 0.5 * (one->ends[0] + one->ends[1]);
    if (one->phase == NARROW) {
        const try_of *around = one->around;
        const int is_before = around[1].at - around[0].at > around[2].at - around[1].at;
        one->at = 0.5 * (around[1].at + around[is_before ? 0 : 2].at);
    }
}

/* Begins the search, within half the range of positions that lead to the pose. */
static inline void begin(family *one, REAL miss)
{
    const try_of none = {0.0, 0.0};
    for (int i = 0; i < 3; ++i) one->grid[i] = one->around[i] = none;
    const REAL slack = roundings(SQRT(one->first.size / one->first.length));
    one->step = (slack < HALF_TURN ? slack : HALF_TURN) / (REAL)GRID_SIZE;
    one->phase = GRID;
    one->number = -1;
    one->side = 1.0;
    one->nearest = LARGEST_NUMBER;
    one->best = miss;
    choose(one);
}

/* Reads what the last try has found, and chooses the next one. */
static inline void search(family *one, REAL miss, int is_solved)
{
    one->best = largest(one->best, miss);
    if (one->phase == GRID) on_grid(one, miss, is_solved);
    else if (one->phase == NARROW) in_between(one, miss, is_solved);
    else {
        one->ends[is_solved] = one->at;
        --one->rounds;
    }
    choose(one);
}

/* Turns the joint from where it was found by an angle. */
static inline int turned_by(family *one, REAL by)
{
    SINES
    const found first = one->first;
    one->joint = turned(first.sine * c + first.cosine * s, first.cosine * c - first.sine * s, 1.0, 1, 0.0, 1.0);
    one->joint.is_second = first.is_second;
    return 1;
}

/* The next position to be tried, if there is one, as the joint. Behind a try count and miss say what was found; solutions of all
   but the last are taken away again. */
static inline int next(family *one, int *count, REAL *miss)
{
    const REAL here = *miss;
    *miss = NO_TRY;
    if (one->phase == AS_FOUND) {
        one->phase = TRIED;
        one->before = *count;
        one->outer = here;
        return 1;
    }
    const int is_solved = *count > one->before;
    if (one->phase == TRIED && (is_solved || is_far(one, here))) {
        *miss = largest(here, one->outer);
        return 0;
    }
    if (one->phase == TRIED) begin(one, here);
    else if (one->phase == LAST) one->phase = OVER;
    else {
        *count = one->before;
        search(one, here, is_solved);
    }
    if (one->phase == OVER) {
        *miss = largest(one->best, one->outer);
        return 0;
    }
    return turned_by(one, one->at * one->side);
}

/* Columns of a rotation: R'R - 1. */
static inline void misses_of(REAL pose[4][4], REAL miss[3][3])
{
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
            const REAL sum = pose[0][i] * pose[0][j] + pose[1][i] * pose[1][j] + pose[2][i] * pose[2][j];
            miss[i][j] = miss[j][i] = i == j ? sum - 1.0 : sum;
        }
    }
}

/* Whether a pose has a rotation but for rounding: two columns have length one and are at right angles, and their vector product is
   the third. */
static inline int is_exact(REAL pose[4][4])
{
    const REAL least = roundings(4.0);
    REAL miss[3][3], sum;
    misses_of(pose, miss);
    sum = miss[0][0] * miss[0][0] + miss[1][1] * miss[1][1] + miss[0][1] * miss[0][1];
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const REAL off = pose[j][0] * pose[k][1] - pose[k][0] * pose[j][1] - pose[i][2];
        sum += off * off;
    }
    return sum <= least * least;
}

/* Whether a pose has a rotation to ROTATION, which does not mirror. */
static inline int is_nearly(REAL pose[4][4], REAL miss[3][3])
{
    REAL volume = 0.0;
    for (int i = 0; i < 9; ++i) {
        if (!(size_of(miss[i / 3][i % 3]) <= ROTATION)) return 0;
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        volume += (pose[j][0] * pose[k][1] - pose[k][0] * pose[j][1]) * pose[i][2];
    }
    return volume > 0.0;
}

/* Copies a pose and returns whether it is one: its position is finite and, where more is read, its last row 0, 0, 0, 1, which a
   transposed pose has as its last column, and its rotation one to ROTATION. The copy has the nearest rotation, the orthogonal part
   of a polar decomposition, by R <- R (3 - R'R) / 2. */
static inline int nearest_pose(const REAL pose[4][4], int reads_rotation, REAL at[4][4])
{
    REAL miss[3][3];
    for (int i = 0; i < 16; ++i) at[i / 4][i % 4] = pose[i / 4][i % 4];
    if (!(is_finite(at[0][3]) && is_finite(at[1][3]) && is_finite(at[2][3]))) return 0;
    if (!reads_rotation) return 1;
    for (int i = 0; i < 4; ++i) {
        if (!(size_of(i == 3 ? at[3][i] - 1.0 : at[3][i]) <= LAST_ROW)) return 0;
    }
    if (is_exact(at)) return 1;
    misses_of(at, miss);
    if (!is_nearly(at, miss)) return 0;
    for (int rounds = 0; rounds < 3; ++rounds, misses_of(at, miss)) {
        for (int i = 0; i < 3; ++i) {
            const REAL row[3] = {at[i][0], at[i][1], at[i][2]};
            for (int j = 0; j < 3; ++j) {
                at[i][j] = row[j] - 0.5 * (row[0] * miss[0][j] + row[1] * miss[1][j] + row[2] * miss[2][j]);
            }
        }
    }
    return 1;
}

/* Writes a solution, unless it is not finite, and returns how many were written. */
static inline int keep(const found *joints, int is_any, REAL *q, int *is_singular)
{
    *is_singular = is_any;
    for (int i = 0; i < JOINTS; ++i) {
        q[i] = joints[i].q;
        *is_singular = *is_singular || joints[i].is_singular;
        if (!is_finite(q[i])) return 0;
    }
    return 1;
}

static inline REAL dot(const REAL a[3], const REAL b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static inline void cross(const REAL a[3], const REAL b[3], REAL product[3])
{
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

/* The direction of a vector, or of the other one if the first vanishes beside size, in the place of the vector. */
static inline void along(REAL v[3], const REAL other[3], REAL size)
{
    const direction_of one = direction(v[0], v[1], v[2], other[0], other[1], other[2], size);
    v[0] = one.x;
    v[1] = one.y;
    v[2] = one.z;
}

/* The part of a vector at right angles to a line. */
static inline void across(const REAL v[3], const REAL line[3], REAL part[3])
{
    const REAL by = dot(v, line);
    for (int i = 0; i < 3; ++i) part[i] = v[i] - line[i] * by;
}

/* The angle of the elbow about the line from shoulder to wrist, from the half plane that holds the direction of axis 1: that line, the
   way from it to the elbow, and the direction of axis 4 are in a frame whose z axis is axis 1. Where the line vanishes beside size,
   or is along axis 1, and where the elbow is on the line, other directions take their place. */
static inline REAL angle_of_elbow(REAL line[3], const REAL elbow[3], const REAL axis[3], REAL size)
{
    const REAL x[3] = {1.0, 0.0, 0.0}, z[3] = {0.0, 0.0, 1.0};
    REAL part[3], other[3], start[3], way[3];
    along(line, z, size);
    across(z, line, part);
    across(x, line, other);
    along(part, other, 1.0);
    across(part, line, start);
    cross(axis, line, other);
    across(elbow, line, part);
    along(part, other, size);
    across(part, line, way);
    cross(start, way, other);
    return angle(dot(line, other), dot(start, way));
}

/* The nearest integer, of two the even one: the sum has no room for other digits. */
static inline REAL nearest_integer(REAL x)
{
    const REAL sum = x + AS_ROUNDER;
    return size_of(x) < AS_ROUNDER / 4.0 ? sum - AS_ROUNDER : x;
}

/* The multiple of a whole turn that is nearest to an angle, or, upwards, the least that is not below it. */
static inline REAL whole_turns(REAL angle, int is_upwards)
{
    const REAL turns = angle / (2.0 * HALF_TURN), nearest = nearest_integer(turns);
    return (is_upwards && nearest < turns ? nearest + 1.0 : nearest) * (2.0 * HALF_TURN);
}

/* The range of a joint; none if both ends are infinite. */
static inline const REAL *range_of(const REAL (*limits)[2], int joint)
{
    const REAL *range = limits ? limits[joint] : 0;
    return range && range[0] < -LARGEST_NUMBER && range[1] > LARGEST_NUMBER ? 0 : range;
}

/* The position of a joint that is whole turns away and nearest to another one, within its range if it has one. */
static inline REAL nearest_turn(int joint, REAL q, REAL seed, const REAL *range)
{
    REAL near;
    if (!turning[joint]) return q;
    near = q + whole_turns(seed - q, 0);
    if (range && near < range[0]) return near + whole_turns(range[0] - near, 1);
    if (range && near > range[1]) return near - whole_turns(near - range[1], 1);
    return near;
}

/* The number of the solution with the least sum of squares of the joints' ways; -1 if there is none. */
static inline int nearest_one(int count, REAL q[][JOINTS], const REAL (*limits)[2], const REAL *seed)
{
    int nearest = -1;
    REAL least = 0.0;
    for (int k = 0; k < count; ++k) {
        REAL distance = 0.0;
        for (int i = 0; i < JOINTS; ++i) {
            const REAL way = nearest_turn(i, q[k][i], seed[i], range_of(limits, i)) - seed[i];
            distance += way * way;
        }
        if (nearest < 0 ? is_finite(distance) : distance < least) {
            nearest = k;
            least = distance;
        }
    }
    return nearest;
}

int NAME_within(int count, REAL q[][JOINTS], int is_singular[], const char *branch[], const REAL limits[JOINTS][2])
{
    int kept = 0;
    for (int k = 0; k < count; ++k) {
        REAL turned[JOINTS];
        int is_within = 1;
        for (int i = 0; i < JOINTS; ++i) {
            const REAL *range = range_of(limits, i);
            turned[i] = nearest_turn(i, q[k][i], q[k][i], range);
            is_within = is_within && (!range || (turned[i] >= range[0] && turned[i] <= range[1]));
        }
        if (!is_within) continue;
        for (int i = 0; i < JOINTS; ++i) q[kept][i] = turned[i];
        is_singular[kept] = is_singular[k];
        if (branch) branch[kept] = branch[k];
        ++kept;
    }
    return count < 0 ? count : kept;
}

int NAME_nearest(int count, REAL q[][JOINTS], const REAL (*limits)[2], const REAL seed[JOINTS], REAL nearest[JOINTS])
{
    const int number = nearest_one(count, q, limits, seed);
    for (int i = 0; i < JOINTS && number >= 0; ++i) {
        const REAL *range = range_of(limits, i);
        nearest[i] = range ? nearest_turn(i, q[number][i], seed[i], range) : q[number][i];
    }
    return number;
}

int NAME_follow(int count, REAL q[][JOINTS], const REAL (*limits)[2], const REAL last[JOINTS], REAL most, int *joint, REAL *way)
{
    const int number = nearest_one(count, q, limits, last);
    *joint = -1;
    *way = number < 0 ? LARGEST_NUMBER : -1.0;
    for (int i = 0; i < JOINTS && number >= 0; ++i) {
        const REAL size = size_of(nearest_turn(i, q[number][i], last[i], range_of(limits, i)) - last[i]);
        if (size > *way) {
            *joint = i;
            *way = size;
        }
    }
    return *way <= most ? number : -1;
}
