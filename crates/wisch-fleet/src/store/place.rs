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

/// Time after which a request to a store fails.
const PATIENCE: Duration = Duration::from_secs(30);
const RETRIES: usize = 4;
/// Largest object [bytes], the limit of S3 for one request.
const LARGEST_OBJECT: u64 = 5 << 30;

/// Place of a fleet.
#[derive(Debug, Clone)]
pub struct StorePlace {
    /// URL, in printed form.
    url: String,
    store: Arc<dyn ObjectStore>,
    prefix: Path,
}

/// Result of creating an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Created {
    /// The object was created.
    New,
    /// An object with this name existed, and stays.
    There,
}

impl StorePlace {
    /// Opens a place: `s3://bucket/prefix`, `file:///folder`, or a folder.
    ///
    /// # Errors
    /// If the URL has another scheme, or contains a user or password.
    pub fn open(url: &str) -> Result<Self, FleetError> {
        let Some((scheme, _)) = url.split_once("://") else {
            return Self::folder(url, std::path::Path::new(url));
        };
        let wrong = |shown: &str, what: &str| FleetError::Url {
            url: shown.to_owned(),
            what: what.to_owned(),
        };
        let Ok(parsed) = Url::parse(url) else {
            // The URL may hold a password, so it is not printed.
            return Err(wrong(&format!("{scheme}://…"), "this is not a URL"));
        };
        if !parsed.username().is_empty() || parsed.password().is_some() {
            let host = parsed.host_str().unwrap_or_default();
            return Err(wrong(
                &format!("{scheme}://…@{host}"),
                "credentials may not be in URLs; set AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY, or write ~/.aws/credentials",
            ));
        }
        if parsed.query().is_some() || parsed.fragment().is_some() {
            let shown = format!("{scheme}://{}…", parsed.host_str().unwrap_or_default());
            return Err(wrong(&shown, "a fleet's URL may not contain ? or #"));
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
                "expected s3://BUCKET/PREFIX, file:///FOLDER or a folder",
            )),
        }
    }

    /// Opens a folder, which is created by the first write.
    fn folder(url: &str, folder: &std::path::Path) -> Result<Self, FleetError> {
        let wrong = |error| FleetError::File {
            path: folder.to_path_buf(),
            error,
        };
        let folder = std::path::absolute(folder).map_err(wrong)?;
        // Object names start at the system's root, so that a reader creates nothing.
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

    /// URL, in printed form.
    pub fn url(&self) -> &str {
        &self.url
    }

    /// URL of the whole store for other processes: `s3://BUCKET` or `file:///`; `None` for a store in this process's
    /// memory.
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

    /// The store from which DataFusion reads.
    pub fn store(&self) -> Arc<dyn ObjectStore> {
        Arc::clone(&self.store)
    }

    /// Path of an object in the store.
    pub fn path(&self, name: &str) -> Path {
        let mut path = self.prefix.clone();
        for part in name.split('/') {
            path = path.join(part);
        }
        path
    }

    /// Name of an object, in printed form.
    pub fn shown(&self, name: &str) -> String {
        format!("{}/{name}", self.url.trim_end_matches('/'))
    }

    fn failed(&self, name: &str) -> impl FnOnce(object_store::Error) -> FleetError {
        let object = self.shown(name);
        |error| FleetError::Store { object, error }
    }

    /// Returns an object; `None` if it does not exist.
    ///
    /// # Errors
    /// If the object is too large, or the store cannot be read.
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
                what: format!("it has {bytes} bytes; the limit is {LARGEST_OBJECT}"),
            });
        }
        found.bytes().await.map(Some).map_err(self.failed(name))
    }

    /// Returns an object.
    ///
    /// # Errors
    /// If the object does not exist, or the store cannot be read.
    pub async fn get(&self, name: &str) -> Result<Bytes, FleetError> {
        let found = self.find(name).await?;
        found.ok_or_else(|| FleetError::Damaged {
            object: self.shown(name),
            what: "it is missing".to_owned(),
        })
    }

    /// Returns the metadata of an object; `None` if it does not exist.
    ///
    /// # Errors
    /// If the store cannot be read.
    pub async fn head(&self, name: &str) -> Result<Option<ObjectMeta>, FleetError> {
        match self.store.head(&self.path(name)).await {
            Ok(meta) => Ok(Some(meta)),
            Err(object_store::Error::NotFound { .. }) => Ok(None),
            Err(error) => Err(self.failed(name)(error)),
        }
    }

    /// Creates an object, unless one with this name exists.
    ///
    /// # Errors
    /// If the store cannot be written.
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

    /// Writes an object, replacing an existing one.
    ///
    /// # Errors
    /// If the store cannot be written.
    pub async fn put(&self, name: &str, bytes: Bytes) -> Result<(), FleetError> {
        let path = self.path(name);
        let put = self.store.put(&path, PutPayload::from(bytes)).await;
        put.map(|_| ()).map_err(self.failed(name))
    }

    /// Removes an object, if it exists.
    ///
    /// # Errors
    /// If the store cannot be written.
    pub async fn delete(&self, name: &str) -> Result<(), FleetError> {
        match self.store.delete(&self.path(name)).await {
            Ok(()) | Err(object_store::Error::NotFound { .. }) => Ok(()),
            Err(error) => Err(self.failed(name)(error)),
        }
    }

    /// Lists the objects of a folder: name, length [bytes] and time of the last change [s since 1970].
    ///
    /// # Errors
    /// If the store cannot be read.
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
