//! Texts that queries print, by the directives of `format/2`.

use super::error::QueryFault;
use super::term::Term;
use std::fmt::Write as _;

/// Largest number of decimals.
const MOST_DIGITS: usize = 100;
/// Number of decimals without a count in the directive.
const DIGITS: usize = 6;
/// Supported directives.
const DIRECTIVES: &str = "~w ~p ~q ~a ~d ~D ~f ~e ~g ~s ~c ~i ~n ~~";

/// Formats arguments, a list or a single term, by a format.
///
/// # Errors
/// If a directive is unknown, or an argument is missing, superfluous or of the wrong type.
pub fn format_answer(format: &Term, arguments: &Term) -> Result<String, QueryFault> {
    let format = text_of(format).ok_or_else(|| fault(format!("{format} is not a text")))?;
    let mut arguments = match arguments {
        Term::List(items) => items.iter(),
        one => std::slice::from_ref(one).iter(),
    };
    let mut text = String::new();
    let mut chars = format.chars().peekable();
    while let Some(c) = chars.next() {
        if c != '~' {
            text.push(c);
            continue;
        }
        let mut number = String::new();
        while let Some(digit) = chars.next_if(char::is_ascii_digit) {
            number.push(digit);
        }
        let count: Option<usize> = number.parse().ok();
        let directive = chars
            .next()
            .ok_or_else(|| fault("it ends with ~".to_owned()))?;
        match directive {
            '~' => text.push('~'),
            'n' => text.extend(std::iter::repeat_n(
                '\n',
                count.unwrap_or(1).min(MOST_DIGITS),
            )),
            'w' | 'p' | 'q' | 'a' | 'd' | 'D' | 'f' | 'e' | 'g' | 's' | 'c' | 'i' => {
                let missing = || fault(format!("~{directive} has no argument"));
                let argument = arguments.next().ok_or_else(missing)?;
                let written = write(directive, count, argument, &mut text);
                written
                    .ok_or_else(|| fault(format!("~{directive}: {argument} has the wrong type")))?;
            }
            other => {
                return Err(fault(format!(
                    "~{other} is unknown; supported are {DIRECTIVES}"
                )));
            }
        }
    }
    match arguments.len() {
        0 => Ok(text),
        more => Err(fault(format!("{more} arguments too many"))),
    }
}

fn fault(what: String) -> QueryFault {
    QueryFault::Prolog {
        what: format!("format: {what}"),
    }
}

/// Returns `None` for an argument of the wrong type.
fn write(directive: char, count: Option<usize>, argument: &Term, out: &mut String) -> Option<()> {
    let digits = count.unwrap_or(DIGITS).min(MOST_DIGITS);
    let written = match directive {
        'w' | 'p' => match argument {
            Term::Atom(name) => write!(out, "{name}"),
            other => write!(out, "{other}"),
        },
        'q' => write!(out, "{argument}"),
        'a' => write!(out, "{}", argument.as_atom()?),
        'd' | 'D' => {
            let Term::Integer(value) = argument else {
                return None;
            };
            write!(
                out,
                "{}",
                format_grouped(*value, count.unwrap_or(0), directive == 'D')
            )
        }
        'f' => write!(out, "{:.digits$}", argument.as_number()?),
        'e' => write!(out, "{}", format_exponential(argument.as_number()?, digits)),
        'g' => write!(out, "{}", argument.as_number()?),
        's' => write!(out, "{}", text_of(argument)?),
        'c' => {
            let Term::Integer(code) = argument else {
                return None;
            };
            let c = char::from_u32(u32::try_from(*code).ok()?)?;
            out.extend(std::iter::repeat_n(c, count.unwrap_or(1).min(MOST_DIGITS)));
            Ok(())
        }
        // Other directives print nothing.
        _ => Ok(()),
    };
    written.ok()
}

/// Formats an integer with a decimal point before its last digits, and commas between thousands.
fn format_grouped(value: i64, behind_point: usize, has_commas: bool) -> String {
    let behind_point = behind_point.min(MOST_DIGITS);
    let digits = format!("{:0>1$}", value.unsigned_abs(), behind_point + 1);
    let (whole, fraction) = digits.split_at(digits.len() - behind_point);
    let mut text = if value < 0 { "-" } else { "" }.to_owned();
    for (place, digit) in whole.chars().enumerate() {
        if has_commas && place > 0 && (whole.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    if behind_point > 0 {
        text.push('.');
        text.push_str(fraction);
    }
    text
}

/// Formats as C does: at least two digits of exponent, with its sign.
fn format_exponential(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$e}");
    match text.split_once('e') {
        Some((mantissa, exponent)) => match exponent.strip_prefix('-') {
            Some(power) => format!("{mantissa}e-{power:0>2}"),
            None => format!("{mantissa}e+{exponent:0>2}"),
        },
        None => text,
    }
}

/// Returns the text of an atom, a number, or a list of characters or codes.
fn text_of(term: &Term) -> Option<String> {
    match term {
        Term::Atom(name) => Some(name.clone()),
        Term::Integer(_) | Term::Float(_) => Some(term.to_string()),
        Term::List(items) => items.iter().map(character).collect(),
        _ => None,
    }
}

fn character(term: &Term) -> Option<char> {
    match term {
        Term::Atom(name) => {
            let mut chars = name.chars();
            chars.next().filter(|_| chars.next().is_none())
        }
        Term::Integer(code) => char::from_u32(u32::try_from(*code).ok()?),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn print(format: &str, arguments: &str) -> Result<String, String> {
        let arguments = Term::parse(arguments).unwrap();
        format_answer(&Term::atom(format), &arguments).map_err(|error| error.to_string())
    }

    #[test]
    fn directives_are_those_of_prolog() {
        for (format, arguments, text) in [
            ("~w and ~q~n", "['a b','a b']", "a b and 'a b'\n"),
            (
                "~a ~d ~2d ~D",
                "[x,12,1234,1234567]",
                "x 12 12.34 1,234,567",
            ),
            (
                "~2f ~0f ~e ~3e",
                "[1.005,2.5,1234.5,-0.001]",
                "1.00 2 1.234500e+03 -1.000e-03",
            ),
            ("~s~c~3c~~~i!", "[[a,b],65,66,ignored]", "abABBB~!"),
            ("~w", "one", "one"),
            ("~2d", "[-5]", "-0.05"),
        ] {
            assert_eq!(print(format, arguments).as_deref(), Ok(text), "{format}");
        }
    }

    #[test]
    fn invalid_formats_are_errors() {
        for (format, arguments, says) in [
            ("~w", "[]", "~w has no argument"),
            ("x", "[a]", "1 arguments too many"),
            ("~d", "[a]", "~d: a has the wrong type"),
            ("~z", "[a]", "~z is unknown"),
            ("~", "[]", "ends with ~"),
        ] {
            let error = print(format, arguments).unwrap_err();
            assert!(error.contains(says), "{format}: {error}");
        }
    }
}
