//! Arithmetic on which all engines agree.

use super::value::{JoinValue, Pattern};

/// Largest magnitude up to which all integers are exact in double precision.
const EXACT: i64 = 1 << 53;

/// Expressions that `is` and comparisons evaluate.
#[derive(Debug, Clone, PartialEq)]
pub enum Expression {
    /// A variable or a number.
    Pattern(Pattern),
    /// A function of one number.
    Unary(Unary, Box<Expression>),
    /// A function of two numbers.
    Binary(Binary, Box<Expression>, Box<Expression>),
}

/// A function of one number in arithmetic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unary {
    /// Negation.
    Minus,
    /// Absolute value.
    Absolute,
    /// Integer part.
    Truncate,
}

/// A function of two numbers in arithmetic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Binary {
    /// Sum.
    Plus,
    /// Difference.
    Minus,
    /// Product.
    Times,
    /// Quotient, if at least one operand is a floating-point number.
    Over,
}

impl Expression {
    /// Appends the variables of the expression to `found`.
    pub fn variables(&self, found: &mut Vec<usize>) {
        match self {
            Self::Pattern(pattern) => pattern.variables(found),
            Self::Unary(_, of) => of.variables(found),
            Self::Binary(_, left, right) => {
                left.variables(found);
                right.variables(found);
            }
        }
    }

    /// Returns its value, if all engines agree on it.
    pub fn evaluate(&self, value: &impl Fn(&Pattern) -> Option<JoinValue>) -> Option<JoinValue> {
        match self {
            Self::Pattern(pattern) => {
                let found = value(pattern)?;
                let is_exact = |n: &i64| n.unsigned_abs() < EXACT.unsigned_abs();
                match &found {
                    JoinValue::Integer(n) => is_exact(n).then_some(found),
                    JoinValue::Float(_) => Some(found),
                    _ => None,
                }
            }
            Self::Unary(function, of) => unary(*function, of.evaluate(value)?),
            Self::Binary(function, left, right) => {
                evaluate_binary(*function, left.evaluate(value)?, right.evaluate(value)?)
            }
        }
    }
}

fn unary(function: Unary, of: JoinValue) -> Option<JoinValue> {
    Some(match (function, of) {
        (Unary::Minus, JoinValue::Integer(n)) => JoinValue::Integer(-n),
        (Unary::Minus, JoinValue::Float(x)) => JoinValue::Float(-x),
        (Unary::Absolute, JoinValue::Integer(n)) => JoinValue::Integer(n.abs()),
        (Unary::Absolute, JoinValue::Float(x)) => JoinValue::Float(x.abs()),
        (Unary::Truncate, JoinValue::Integer(n)) => JoinValue::Integer(n),
        #[allow(clippy::cast_possible_truncation, reason = "within what is exact")]
        (Unary::Truncate, JoinValue::Float(x)) if x.abs() < 1e15 => {
            JoinValue::Integer(x.trunc() as i64)
        }
        _ => return None,
    })
}

/// Returns the value of a function of two numbers.
pub fn evaluate_binary(function: Binary, left: JoinValue, right: JoinValue) -> Option<JoinValue> {
    if let (JoinValue::Integer(a), JoinValue::Integer(b)) = (&left, &right) {
        let (a, b) = (*a, *b);
        let whole = match function {
            Binary::Plus => a.checked_add(b),
            Binary::Minus => a.checked_sub(b),
            Binary::Times => a.checked_mul(b),
            // Engines differ here.
            Binary::Over => None,
        };
        return whole
            .filter(|n| n.unsigned_abs() < EXACT.unsigned_abs())
            .map(JoinValue::Integer);
    }
    let (a, b) = (left.as_number()?, right.as_number()?);
    let found = match function {
        Binary::Plus => a + b,
        Binary::Minus => a - b,
        Binary::Times => a * b,
        Binary::Over => a / b,
    };
    // The engine reports operands that are not numbers.
    found.is_finite().then_some(JoinValue::Float(found))
}

/// A comparison of the values of two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comparison {
    /// Less than or equal.
    AtMost,
    /// Greater than or equal.
    AtLeast,
    /// Less than.
    Less,
    /// Greater than.
    More,
    /// Equal in value.
    Equal,
    /// Different in value.
    Different,
}

impl Comparison {
    /// Returns the comparison with this operator.
    pub fn from_name(name: &str) -> Option<Self> {
        Some(match name {
            "=<" => Self::AtMost,
            ">=" => Self::AtLeast,
            "<" => Self::Less,
            ">" => Self::More,
            "=:=" => Self::Equal,
            "=\\=" => Self::Different,
            _ => return None,
        })
    }

    /// Whether the comparison holds for two numbers.
    #[allow(clippy::float_cmp, reason = "the query asks for exact equality")]
    pub fn holds(self, a: f64, b: f64) -> bool {
        match self {
            Self::AtMost => a <= b,
            Self::AtLeast => a >= b,
            Self::Less => a < b,
            Self::More => a > b,
            Self::Equal => a == b,
            Self::Different => a != b,
        }
    }
}
