//! Credentials from the usual file, if the environment has none. They have no other source, and are never printed.

use std::path::PathBuf;

/// Credentials that sign requests.
pub(super) struct Credentials {
    pub key_id: String,
    pub secret: String,
    pub token: Option<String>,
}

/// Reads the profile `AWS_PROFILE` or `default` of `~/.aws/credentials` or `AWS_SHARED_CREDENTIALS_FILE`. `None` if the
/// environment has credentials, or there is no such file or profile.
pub(super) fn from_file() -> Option<Credentials> {
    if variable("AWS_ACCESS_KEY_ID").is_some() {
        return None;
    }
    let place = variable("AWS_SHARED_CREDENTIALS_FILE").map(PathBuf::from);
    let place =
        place.or_else(|| Some(PathBuf::from(variable("HOME")?).join(".aws/credentials")))?;
    let text = std::fs::read_to_string(place).ok()?;
    let profile = variable("AWS_PROFILE").unwrap_or_else(|| "default".to_owned());
    in_profile(&text, &profile)
}

fn variable(name: &str) -> Option<String> {
    std::env::var(name).ok().filter(|value| !value.is_empty())
}

/// Returns all secrets, which must not be printed.
#[cfg(feature = "cluster")]
pub(crate) fn secrets() -> Vec<String> {
    let names = [
        "AWS_ACCESS_KEY_ID",
        "AWS_SECRET_ACCESS_KEY",
        "AWS_SESSION_TOKEN",
    ];
    let mut all: Vec<String> = names.into_iter().filter_map(variable).collect();
    if let Some(found) = from_file() {
        all.extend([found.key_id, found.secret]);
        all.extend(found.token);
    }
    all
}

fn in_profile(text: &str, profile: &str) -> Option<Credentials> {
    let head = format!("[{profile}]");
    let lines = text.lines().map(str::trim);
    let mut lines = lines.skip_while(|line| *line != head);
    lines.next()?;
    let [mut key_id, mut secret, mut token] = [None, None, None];
    for line in lines.take_while(|line| !line.starts_with('[')) {
        let Some((name, value)) = line.split_once('=') else {
            continue;
        };
        let value = Some(value.trim().to_owned());
        match name.trim() {
            "aws_access_key_id" => key_id = value,
            "aws_secret_access_key" => secret = value,
            "aws_session_token" => token = value,
            _ => {}
        }
    }
    Some(Credentials {
        key_id: key_id?,
        secret: secret?,
        token,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_profile_is_read_and_no_other() {
        let text = "[default]\naws_access_key_id = a\naws_secret_access_key=b\n\n[fleet]\n\
                    aws_access_key_id=c\naws_secret_access_key = d=e\naws_session_token = f\n";
        let found = in_profile(text, "default").unwrap();
        assert_eq!((found.key_id.as_str(), found.secret.as_str()), ("a", "b"));
        assert_eq!(found.token, None);
        let found = in_profile(text, "fleet").unwrap();
        assert_eq!((found.key_id.as_str(), found.secret.as_str()), ("c", "d=e"));
        assert_eq!(found.token.as_deref(), Some("f"));
        assert!(in_profile(text, "none").is_none());
    }
}
