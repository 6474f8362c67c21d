//! C99, which is C++ and device code as well: a header and a source.

mod batch;
mod cpp;
pub(crate) mod precision;
mod project;
mod sines;

pub use precision::CNumbers;

use crate::arguments::{argument_names, argument_sizes};
use crate::body::Body;
use crate::comments::{comment, lines, title_lines};
use crate::names::{free_name, snake_case};
use crate::syntax::indented;
use core::fmt::Write as _;
use dynamics_symbolic::function::{Request, Shape, Size, Sizes};
use dynamics_symbolic::program::Proven;
use dynamics_symbolic::robot::Robot;
use precision::Precision;

/// A robot in C.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CSource {
    /// The beginning of the names of the files, and of all names in them: `panda` of `panda.h` and `panda.c`.
    pub name: String,
    /// The text of the header.
    pub header: String,
    /// The text of the source.
    pub source: String,
}

/// The keywords of C and of C++, and the constants that compilers and standard headers define as macros.
pub(crate) const WORDS: &str = "
alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl concept
const const_cast consteval constexpr constinit continue co_await co_return co_yield decltype default
delete do double dynamic_cast else enum explicit export extern false float for friend goto if inline
int long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected
public register reinterpret_cast requires restrict return short signed sizeof static static_assert
static_cast struct switch template this thread_local throw true try typedef typeid typename typeof
union unsigned using virtual void volatile wchar_t while xor xor_eq _Bool _Complex
BUFSIZ EOF HUGE_VAL HUGE_VALF HUGE_VALL INFINITY NAN NULL RAND_MAX linux unix math_errhandling stdin stdout stderr
M_1_PI M_2_PI M_2_SQRTPI M_E M_LN10 M_LN2 M_LOG10E M_LOG2E M_PI M_PI_2 M_PI_4 M_SQRT1_2 M_SQRT2
";

const REFUSAL: &str = "Returns 0; or, where M(q) is not positive definite to working precision or not finite, the \
                       number of the joint whose pivot failed, counted from 1, and writes nothing.";

/// The specifier of every function.
pub(crate) const DEVICE: &str = "\
/* The specifier of every function: device code compiles it for both sides. */
#ifndef ROBOT_DYNAMICS_DEVICE
#if defined(__CUDACC__) || defined(__HIPCC__)
#define ROBOT_DYNAMICS_DEVICE __host__ __device__
#else
#define ROBOT_DYNAMICS_DEVICE
#endif
#endif
";

/// More lines in a loop take gcc five seconds.
const LONG: usize = 1_500;

/// The advice about the time to compile, measured in the guide (`languages.md`).
const OF_LONG_BATCHES: [&str; 3] = [
    "Some functions are long, and compilers spend most of their time on lanes of their batches. Without batches take `-O2`, which is",
    "as fast. With batches clang takes a fifth of the time of gcc, and gcc two thirds by `--param max-combine-insns=2 -fira-region=one`.",
    "",
];

/// The functions of a robot in C99, each with its program. A method of several functions writes the values of each.
pub fn c_source(robot: &Robot, functions: &[(Request, Proven)]) -> CSource {
    c_source_in(robot, functions, CNumbers::Double)
}

/// The same with numbers of that kind.
pub fn c_source_in(robot: &Robot, functions: &[(Request, Proven)], numbers: CNumbers) -> CSource {
    Writer::new(robot, numbers).files(functions)
}

/// The same without functions over columns of states, which a controller has no use for.
pub fn c_source_without_batches(
    robot: &Robot,
    functions: &[(Request, Proven)],
    numbers: CNumbers,
) -> CSource {
    let writer = Writer {
        has_batches: false,
        ..Writer::new(robot, numbers)
    };
    writer.files(functions)
}

/// The files that make a project of header and source: `NAME.hpp` for C++, `CMakeLists.txt`, and `NAME_test.c`, which
/// compares every batch with single calls.
pub fn c_project(
    robot: &Robot,
    functions: &[(Request, Proven)],
    numbers: CNumbers,
) -> [(String, String); 3] {
    let writer = Writer::new(robot, numbers);
    let name = &writer.name;
    [
        (format!("{name}.hpp"), writer.cpp(functions)),
        ("CMakeLists.txt".to_owned(), writer.cmake()),
        (format!("{name}_test.c"), writer.test(functions)),
    ]
}

struct Writer<'a> {
    robot: &'a Robot,
    precision: &'static Precision,
    name: String,
    has_batches: bool,
}

/// A place that a function writes to: its type and name, and the texts of its entries.
struct Written {
    name: String,
    dimensions: Vec<usize>,
}

impl<'a> Writer<'a> {
    fn new(robot: &'a Robot, numbers: CNumbers) -> Self {
        Writer {
            robot,
            precision: numbers.precision(),
            name: snake_case(&robot.name),
            has_batches: true,
        }
    }

    fn files(self, functions: &[(Request, Proven)]) -> CSource {
        CSource {
            header: self.header(functions),
            source: self.source(functions),
            name: self.name,
        }
    }

    fn header(&self, functions: &[(Request, Proven)]) -> String {
        let (name, upper) = (&self.name, self.name.to_uppercase());
        let title = self.title(functions);
        let joints: Vec<_> = self.robot.joints().map(|row| string(&row.name)).collect();
        let word = self.precision.word;
        let member = |field: &String| format!("{word} {};", free_name(field, WORDS));
        let members: Vec<_> = self.robot.fields.iter().map(member).collect();
        let fields = match &members[..] {
            [] => String::new(),
            fields => format!(
                "\n/** The symbolic parameters of the table. */\ntypedef struct {{\n{}}} {name}_fields;\n",
                indented(fields, 4)
            ),
        };
        let counted = if self.robot.freedoms().has_base() {
            "Degrees of freedom: six of the base, then the joints that move"
        } else {
            "Joints that move"
        };
        let declaration = |(request, proven): &(Request, Proven)| {
            let documentation = comment(&lines(self.robot, request, proven, REFUSAL));
            let signature = self.signature(request, proven);
            let batch = self
                .has_batches
                .then(|| self.batch_declaration(request, proven));
            format!(
                "\n{documentation}{signature};\n{}",
                batch.unwrap_or_default()
            )
        };
        let declarations: String = functions.iter().map(declaration).collect();
        format!(
            "{title}#ifndef {upper}_H\n#define {upper}_H\n\n\
             {DEVICE}\n\
             /* {counted}, and their names from the base outwards. */\n\
             #define {upper}_DOF {}\n\
             #define {upper}_JOINT_NAMES {{{}}}\n\n\
             #include <stddef.h>\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\
             {fields}{declarations}\
             \n#ifdef __cplusplus\n}}\n#endif\n\n#endif\n",
            self.robot.dof(),
            joints.join(", ")
        )
    }

    /// The comment at the top of the header.
    fn title(&self, functions: &[(Request, Proven)]) -> String {
        let conventions = [
            "Each function is proven equal to the textbook Lagrangian. SI units, radians; matrices by rows.",
            "Nothing is allocated, no state is kept. A value that depends on an input that is not finite is not finite.",
        ];
        let of_batches = [
            "",
            "Functions whose names end in `_batch` take columns of states, with the digits of the functions of one state, and are",
            "turned into lanes by `-O3 -march=native`. A column that is written may be one that is read, and overlaps no other.",
            "",
        ];
        let mut lines = title_lines(self.robot, conventions).to_vec();
        let mut programs = functions.iter().map(|(_, proven)| &proven.program);
        if self.has_batches {
            lines.extend(of_batches.map(str::to_owned));
            if programs.any(|program| program.lines().iter().flatten().count() > LONG) {
                lines.extend(OF_LONG_BATCHES.map(str::to_owned));
            }
        }
        lines.extend(self.precision.digits.iter().map(|&line| line.to_owned()));
        comment(&lines)
    }

    fn source(&self, functions: &[(Request, Proven)]) -> String {
        let functions = functions.iter();
        let bodies: String = functions
            .flat_map(|(request, proven)| {
                let proven = proven.ordered();
                let batch = self.has_batches.then(|| self.batch(request, &proven));
                [Some(self.function(request, &proven)), batch]
            })
            .flatten()
            .collect();
        let functions = self.precision.functions(&bodies);
        format!("#include \"{}.h\"\n{functions}{bodies}", self.name)
    }

    fn function(&self, request: &Request, proven: &Proven) -> String {
        let body = Body::new(self.robot, proven, &self.precision.syntax);
        let statements = body.statements(request);
        let unread = self.unread(request, &statements).into_iter();
        let mut lines: Vec<_> = unread
            .map(|argument| format!("(void){argument};"))
            .collect();
        lines.extend(statements);
        let values = body.values(request);
        if is_number(request) {
            lines.push(format!("return {};", values[0][0]));
        } else {
            let written = self.written(request, proven);
            let entries = written.iter().flat_map(Written::entries);
            let values = entries.zip(values.iter().flatten());
            lines.extend(values.map(|(place, value)| format!("{place} = {value};")));
            if request.refuses() {
                lines.push("return 0;".to_owned());
            }
        }
        let signature = self.signature(request, proven);
        format!("\n{signature}\n{{\n{}}}\n", indented(&lines, 4))
    }

    /// The arguments that no statement reads.
    fn unread(&self, request: &Request, statements: &[String]) -> Vec<&'static str> {
        let is_unread = |argument: &&str| {
            let reads = [format!("{argument}["), format!("{argument}->")];
            let is_read = |statement: &String| reads.iter().any(|read| reads_name(statement, read));
            !statements.iter().any(is_read)
        };
        let names = argument_names(self.robot, request).into_iter();
        names.filter(is_unread).collect()
    }

    fn signature(&self, request: &Request, proven: &Proven) -> String {
        let word = self.precision.word;
        let result = match (is_number(request), request.refuses()) {
            (true, _) => word,
            (_, true) => "int",
            _ => "void",
        };
        let sizes = proven.sizes(request, self.robot.freedoms());
        let mut parameters = Vec::new();
        if !self.robot.fields.is_empty() {
            parameters.push(format!("const {}_fields *arm", self.name));
        }
        for (argument, entries) in argument_sizes(request, sizes) {
            parameters.push(match entries {
                // Joint positions where there are no joints: no array of C is without entries.
                0 => format!("const {word} *{}", argument.name()),
                _ => format!("const {word} {}[{entries}]", argument.name()),
            });
        }
        if !is_number(request) {
            let written = self.written(request, proven);
            parameters.extend(written.iter().map(|written| written.parameter(word)));
        }
        if parameters.is_empty() {
            parameters.push("void".to_owned());
        }
        let function = request.name();
        format!(
            "ROBOT_DYNAMICS_DEVICE {result} {}_{function}({})",
            self.name,
            parameters.join(", ")
        )
    }

    /// The places that a function writes to, or the value that it returns: none for a value without entries, which no array
    /// of C is.
    fn written(&self, request: &Request, proven: &Proven) -> Vec<Written> {
        let sizes = proven.sizes(request, self.robot.freedoms());
        let mut written = Vec::new();
        for part in request.parts() {
            let name = if request.is_tuple() {
                self.robot.name_of(*part)
            } else {
                part.function.name().to_owned()
            };
            let shapes: Vec<(String, &Shape)> = match part.function.shape() {
                Shape::Tuple(shapes) => {
                    let shapes = shapes.iter();
                    shapes
                        .map(|(name, shape)| ((*name).to_owned(), shape))
                        .collect()
                }
                shape => vec![(name, shape)],
            };
            for (name, shape) in shapes {
                if shape.entries(sizes) > 0 {
                    let dimensions = dimensions(shape, sizes);
                    written.push(Written { name, dimensions });
                }
            }
        }
        written
    }
}

/// A string literal. `?` is escaped because `??/` is a backslash in C99 (ISO/IEC 9899:1999, 5.2.1.1); letters that do
/// not show themselves are written as the octal bytes of UTF-8.
pub(crate) fn string(text: &str) -> String {
    let mut literal = "\"".to_owned();
    for letter in text.chars() {
        match letter {
            '"' | '\\' | '?' => literal.extend(['\\', letter]),
            ' '..='~' => literal.push(letter),
            _ if letter.is_alphanumeric() => literal.push(letter),
            _ => {
                for byte in letter.encode_utf8(&mut [0; 4]).bytes() {
                    let _ = write!(literal, "\\{byte:03o}");
                }
            }
        }
    }
    literal + "\""
}

/// Whether the value is one number, which is returned.
fn is_number(request: &Request) -> bool {
    request
        .function()
        .is_some_and(|function| *function.shape() == Shape::Number)
}

/// Whether a statement has the beginning of a read in it, and not as the end of a longer name.
pub(crate) fn reads_name(statement: &str, read: &str) -> bool {
    let is_letter = |letter: char| letter.is_alphanumeric() || letter == '_';
    let mut found = statement.match_indices(read);
    found.any(|(at, _)| !statement[..at].ends_with(is_letter))
}

/// The sizes of an array, none of a number.
fn dimensions(shape: &Shape, sizes: Sizes) -> Vec<usize> {
    match shape {
        Shape::Matrix(rows, Size::One) => vec![rows.of(sizes)],
        Shape::Matrix(rows, columns) => vec![rows.of(sizes), columns.of(sizes)],
        Shape::Each(count, one) => {
            let mut all = vec![count.of(sizes)];
            all.extend(dimensions(one, sizes));
            all
        }
        // Tuples in tuples: none of the functions has any.
        Shape::Tuple(_) => vec![shape.entries(sizes)],
        Shape::Number | Shape::Series => Vec::new(),
    }
}

impl Written {
    /// The name without indices: a number has a pointer to it.
    fn without_indices(&self) -> String {
        let pointer = if self.dimensions.is_empty() { "*" } else { "" };
        format!("{pointer}{}", self.name)
    }

    fn parameter(&self, word: &str) -> String {
        let dimensions = self.dimensions.iter().map(|size| format!("[{size}]"));
        format!(
            "{word} {}{}",
            self.without_indices(),
            dimensions.collect::<String>()
        )
    }

    /// The text of each entry, in the order of the values.
    fn entries(&self) -> Vec<String> {
        let mut entries = vec![self.without_indices()];
        for &size in &self.dimensions {
            let indexed = |entry: &String| -> Vec<String> {
                (0..size).map(|i| format!("{entry}[{i}]")).collect()
            };
            entries = entries.iter().flat_map(indexed).collect();
        }
        entries
    }
}
