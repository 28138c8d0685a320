//! Objects by name, in a folder or a bucket.

use super::credentials;
use super::error::FleetError;
use bytes::Bytes;
use futures::{StreamExt, TryStreamExt};
use object_store::aws::AmazonS3Builder;
use object_store::local::LocalFileSystem;
use object_store::memory::InMemory;
use object_store::path::Path;
use object_store::{
    ObjectMeta, ObjectStore, ObjectStoreExt, PutMode, PutOptions, PutPayload, RetryConfig,
};
use std::sync::Arc;
use std::time::Duration;
use url::Url;

/// A store that does not answer is given up after this: who waits is told then.
const PATIENCE: Duration = Duration::from_secs(30);
const RETRIES: usize = 4;
/// Most bytes of an object: as much as S3 takes in one request.
const LARGEST_OBJECT: u64 = 5 << 30;

/// A fleet's place.
#[derive(Debug, Clone)]
pub struct StorePlace {
    /// As it is printed.
    url: String,
    store: Arc<dyn ObjectStore>,
    prefix: Path,
}

/// What came of creating an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Created {
    /// It is there now.
    New,
    /// One of this name was there already, and stays.
    There,
}

impl StorePlace {
    /// The place of a URL: `s3://bucket/prefix`, `file:///folder`, or a folder.
    ///
    /// # Errors
    /// A URL of another kind, or one with a user or a password in it.
    pub fn open(url: &str) -> Result<Self, FleetError> {
        let Some((scheme, _)) = url.split_once("://") else {
            return Self::folder(url, std::path::Path::new(url));
        };
        let wrong = |shown: &str, what: &str| FleetError::Url {
            url: shown.to_owned(),
            what: what.to_owned(),
        };
        let Ok(parsed) = Url::parse(url) else {
            // It may hold a password: nothing of it is repeated.
            return Err(wrong(&format!("{scheme}://…"), "this is not a URL"));
        };
        if !parsed.username().is_empty() || parsed.password().is_some() {
            let host = parsed.host_str().unwrap_or_default();
            return Err(wrong(
                &format!("{scheme}://…@{host}"),
                "credentials are not taken from URLs: set AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY, or write ~/.aws/credentials",
            ));
        }
        if parsed.query().is_some() || parsed.fragment().is_some() {
            let shown = format!("{scheme}://{}…", parsed.host_str().unwrap_or_default());
            return Err(wrong(&shown, "a place has no ? and no #"));
        }
        match scheme {
            "file" => {
                let folder = parsed.to_file_path();
                let folder = folder.map_err(|()| wrong(url, "this is not a folder"))?;
                Self::folder(url, &folder)
            }
            "s3" => Self::bucket(url, &parsed),
            "memory" => Ok(Self {
                url: url.to_owned(),
                store: Arc::new(InMemory::new()),
                prefix: Path::default(),
            }),
            _ => Err(wrong(
                url,
                "known are s3://BUCKET/PREFIX, file:///FOLDER and a folder",
            )),
        }
    }

    /// A folder, which is made when something is written.
    fn folder(url: &str, folder: &std::path::Path) -> Result<Self, FleetError> {
        let wrong = |error| FleetError::File {
            path: folder.to_path_buf(),
            error,
        };
        let folder = std::path::absolute(folder).map_err(wrong)?;
        // Names of objects are below the system's root, so that there is nothing to make for who only reads.
        let prefix = Path::from_absolute_path(&folder).map_err(|error| FleetError::Url {
            url: url.to_owned(),
            what: error.to_string(),
        })?;
        Ok(Self {
            url: url.to_owned(),
            store: Arc::new(LocalFileSystem::new().with_automatic_cleanup(false)),
            prefix,
        })
    }

    fn bucket(url: &str, parsed: &Url) -> Result<Self, FleetError> {
        let wrong = |what: String| FleetError::Url {
            url: url.to_owned(),
            what,
        };
        let retry = RetryConfig {
            max_retries: RETRIES,
            retry_timeout: PATIENCE,
            ..RetryConfig::default()
        };
        let bucket = parsed.host_str().unwrap_or_default();
        let mut builder = AmazonS3Builder::from_env()
            .with_bucket_name(bucket)
            .with_retry(retry);
        if let Some(found) = credentials::from_file() {
            builder = builder
                .with_access_key_id(found.key_id)
                .with_secret_access_key(found.secret);
            if let Some(token) = found.token {
                builder = builder.with_token(token);
            }
        }
        let store = builder.build().map_err(|error| wrong(error.to_string()))?;
        let prefix = Path::from_url_path(parsed.path());
        Ok(Self {
            url: url.trim_end_matches('/').to_owned(),
            store: Arc::new(store),
            prefix: prefix.map_err(|error| wrong(error.to_string()))?,
        })
    }

    /// As it is printed.
    pub fn url(&self) -> &str {
        &self.url
    }

    /// The whole store that the place is in, as others find it: `s3://BUCKET` or `file:///`; `None` if it is in the memory of this process.
    pub fn root(&self) -> Option<String> {
        match self.url.split_once("://") {
            Some(("s3", rest)) => {
                let bucket = rest.split('/').next().unwrap_or_default();
                Some(format!("s3://{bucket}"))
            }
            Some(("memory", _)) => None,
            _ => Some("file:///".to_owned()),
        }
    }

    /// What DataFusion reads from.
    pub fn store(&self) -> Arc<dyn ObjectStore> {
        Arc::clone(&self.store)
    }

    /// Where an object stands in the store.
    pub fn path(&self, name: &str) -> Path {
        let mut path = self.prefix.clone();
        for part in name.split('/') {
            path = path.join(part);
        }
        path
    }

    /// An object as it is printed.
    pub fn shown(&self, name: &str) -> String {
        format!("{}/{name}", self.url.trim_end_matches('/'))
    }

    fn failed(&self, name: &str) -> impl FnOnce(object_store::Error) -> FleetError {
        let object = self.shown(name);
        |error| FleetError::Store { object, error }
    }

    /// An object; `None` if there is none.
    ///
    /// # Errors
    /// More than an object may hold, or what the store says.
    pub async fn find(&self, name: &str) -> Result<Option<Bytes>, FleetError> {
        let found = match self.store.get(&self.path(name)).await {
            Ok(found) => found,
            Err(object_store::Error::NotFound { .. }) => return Ok(None),
            Err(error) => return Err(self.failed(name)(error)),
        };
        let bytes = found.meta.size;
        if bytes > LARGEST_OBJECT {
            return Err(FleetError::Damaged {
                object: self.shown(name),
                what: format!("it has {bytes} bytes, at most {LARGEST_OBJECT} are read"),
            });
        }
        found.bytes().await.map(Some).map_err(self.failed(name))
    }

    /// An object.
    ///
    /// # Errors
    /// If there is none, or what the store says.
    pub async fn get(&self, name: &str) -> Result<Bytes, FleetError> {
        let found = self.find(name).await?;
        found.ok_or_else(|| FleetError::Damaged {
            object: self.shown(name),
            what: "it is missing".to_owned(),
        })
    }

    /// What is known of an object; `None` if there is none.
    ///
    /// # Errors
    /// What the store says.
    pub async fn head(&self, name: &str) -> Result<Option<ObjectMeta>, FleetError> {
        match self.store.head(&self.path(name)).await {
            Ok(meta) => Ok(Some(meta)),
            Err(object_store::Error::NotFound { .. }) => Ok(None),
            Err(error) => Err(self.failed(name)(error)),
        }
    }

    /// Creates an object, unless there is one of this name.
    ///
    /// # Errors
    /// What the store says.
    pub async fn create(&self, name: &str, bytes: Bytes) -> Result<Created, FleetError> {
        let path = self.path(name);
        let options = PutOptions::from(PutMode::Create);
        match self
            .store
            .put_opts(&path, PutPayload::from(bytes), options)
            .await
        {
            Ok(_) => Ok(Created::New),
            Err(object_store::Error::AlreadyExists { .. }) => Ok(Created::There),
            Err(error) => Err(self.failed(name)(error)),
        }
    }

    /// Writes an object, whether there is one or not.
    ///
    /// # Errors
    /// What the store says.
    pub async fn put(&self, name: &str, bytes: Bytes) -> Result<(), FleetError> {
        let path = self.path(name);
        let put = self.store.put(&path, PutPayload::from(bytes)).await;
        put.map(|_| ()).map_err(self.failed(name))
    }

    /// Removes an object, if it is there.
    ///
    /// # Errors
    /// What the store says.
    pub async fn delete(&self, name: &str) -> Result<(), FleetError> {
        match self.store.delete(&self.path(name)).await {
            Ok(()) | Err(object_store::Error::NotFound { .. }) => Ok(()),
            Err(error) => Err(self.failed(name)(error)),
        }
    }

    /// The objects whose names begin with this folder: name, length [bytes] and age [s since 1970] of each.
    ///
    /// # Errors
    /// What the store says.
    pub async fn list(&self, folder: &str) -> Result<Vec<(String, u64, f64)>, FleetError> {
        let path = self.path(folder);
        let depth = self.prefix.parts().count();
        let listed = self.store.list(Some(&path)).map(|meta| {
            let meta = meta?;
            let parts = meta.location.parts().skip(depth);
            let parts: Vec<String> = parts.map(|part| part.as_ref().to_owned()).collect();
            let time = meta.last_modified.timestamp_millis() as f64 * 1e-3;
            Ok((parts.join("/"), meta.size, time))
        });
        listed.try_collect().await.map_err(self.failed(folder))
    }
}
