//! Objects by the S3 protocol. Endpoint, region and credentials come from the environment variables `AWS_*`.
//!
//! An object is complete or absent: nobody sees it before its upload has ended. The library repeats requests that fail.

use object_store::aws::{AmazonS3, AmazonS3Builder};
use object_store::list::{PaginatedListOptions, PaginatedListStore};
use object_store::path::{DELIMITER, Path as Key};
use object_store::{Error, ObjectStoreExt, RetryConfig, WriteMultipart};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};
use std::time::Duration;
use tokio::runtime::{Builder, Runtime};

/// How long a request that fails is repeated. An attempt has half a minute by itself.
const RETRIED: Duration = Duration::from_secs(30);

/// Bytes of a request of an upload. A larger file is uploaded in pieces.
const PIECE: u64 = 16 << 20;

/// S3 allows 10000 pieces of an object.
const MOST_PIECES: u64 = 9000;

/// Pieces that are uploaded at a time.
const AT_A_TIME: usize = 4;

/// Waits for the network on a thread of its own, for all threads that compute.
static RUNTIME: LazyLock<io::Result<Runtime>> = LazyLock::new(|| {
    // An error only says that there is a provider already.
    let _ = rustls::crypto::ring::default_provider().install_default();
    let mut builder = Builder::new_multi_thread();
    builder.worker_threads(1).enable_all().build()
});

/// What the library says of a list that is none, and of an answer without the hash or the length of an object.
const NO_ANSWER: [&str; 2] = ["invalid list response", " Header missing"];

static BUCKETS: Mutex<BTreeMap<String, Arc<AmazonS3>>> = Mutex::new(BTreeMap::new());

/// The names directly under a prefix, each with whether it is a prefix itself.
pub fn list(folder: &Path) -> io::Result<Vec<(String, bool)>> {
    let found = request(folder, async |bucket, key| {
        let prefix = match key.as_ref() {
            "" => String::new(),
            key => format!("{key}{DELIMITER}"),
        };
        let (mut keys, mut tokens, mut token) = (BTreeSet::new(), BTreeSet::new(), None);
        loop {
            let options = PaginatedListOptions {
                delimiter: Some(DELIMITER.into()),
                page_token: token,
                ..PaginatedListOptions::default()
            };
            let page = bucket.list_paginated(Some(&prefix), options).await?;
            let (prefixes, objects) = (page.result.common_prefixes, page.result.objects);
            let named = objects.into_iter().map(|object| (object.location, false));
            let under = prefixes.into_iter().map(|prefix| (prefix, true));
            let given: BTreeSet<(Key, bool)> = under.chain(named).collect();
            // The list would have no end.
            let repeated = !given.is_empty() && given.is_subset(&keys);
            keys.extend(given);
            token = page.page_token.filter(|token| !token.is_empty());
            match &token {
                None => return Ok(keys),
                Some(token) if repeated || !tokens.insert(token.clone()) => return Err(repeats()),
                Some(_) => {}
            }
        }
    })?;
    let name = |(key, is_prefix): (Key, bool)| Some((key.filename()?.to_owned(), is_prefix));
    Ok(found.into_iter().filter_map(name).collect())
}

/// The error of a server that gives one page of a list twice.
fn repeats() -> Error {
    Error::Generic {
        store: "S3",
        source: "the server repeats a page of the list of objects".into(),
    }
}

/// The bytes of an object.
pub fn read(path: &Path) -> io::Result<Vec<u8>> {
    let bytes = request(path, async |bucket, key| {
        bucket.get(key).await?.bytes().await
    });
    bytes.map(Vec::from)
}

/// Whether there is an object with this name.
pub fn is_there(path: &Path) -> bool {
    request(path, async |bucket, key| bucket.head(key).await).is_ok()
}

/// Uploads a file as an object, and replaces an object of this name.
pub fn write(path: &Path, file: &Path) -> io::Result<()> {
    let mut file = File::open(file)?;
    let len = file.metadata()?.len();
    let piece = PIECE.max(len.div_ceil(MOST_PIECES));
    let mut next = || -> object_store::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        let read = Read::by_ref(&mut file).take(piece).read_to_end(&mut bytes);
        read.map_err(|e| Error::Generic {
            store: "local",
            source: e.into(),
        })?;
        Ok(bytes)
    };
    request(path, async |bucket, key| {
        if len <= piece {
            bucket.put(key, next()?.into()).await?;
            return Ok(());
        }
        let started = bucket.put_multipart(key).await?;
        let mut upload = WriteMultipart::new_with_chunk_size(started, piece as usize);
        match send(&mut upload, &mut next).await {
            Ok(()) => upload.finish().await.map(drop),
            Err(error) => {
                // The pieces that have arrived would remain, unseen.
                let _ = upload.abort().await;
                Err(error)
            }
        }
    })
}

/// Sends what `next` gives until it gives nothing.
async fn send(
    upload: &mut WriteMultipart,
    next: &mut impl FnMut() -> object_store::Result<Vec<u8>>,
) -> object_store::Result<()> {
    loop {
        let bytes = next()?;
        if bytes.is_empty() {
            return Ok(());
        }
        upload.wait_for_capacity(AT_A_TIME).await?;
        upload.put(bytes.into());
    }
}

/// Removes an object.
pub fn remove(path: &Path) -> io::Result<()> {
    request(path, async |bucket, key| bucket.delete(key).await)
}

/// What the bucket in a path answers to a request about the key in it.
fn request<T>(
    path: &Path,
    ask: impl AsyncFnOnce(&AmazonS3, &Key) -> object_store::Result<T>,
) -> io::Result<T> {
    let (name, key) = split(path)?;
    let runtime = RUNTIME
        .as_ref()
        .map_err(|e| io::Error::other(e.to_string()))?;
    let asked = bucket(&name).map(|bucket| runtime.block_on(ask(&bucket, &key)));
    asked.flatten().map_err(|error| plain(&name, &error))
}

/// The bucket and the key of `s3://BUCKET/KEY`. The key is the path as it is.
fn split(path: &Path) -> io::Result<(String, Key)> {
    let invalid = |why: String| io::Error::new(ErrorKind::InvalidInput, why);
    let given = path.to_str();
    let utf8 = given.ok_or_else(|| invalid("must be UTF-8 text".into()))?;
    let text = match cfg!(windows) {
        true => utf8.replace('\\', "/"),
        false => utf8.to_owned(),
    };
    let after_scheme = text.strip_prefix("s3:/").unwrap_or(&text);
    let rest = after_scheme.strip_prefix('/').unwrap_or(after_scheme);
    let (bucket, key) = rest.split_once('/').unwrap_or((rest, ""));
    if bucket.is_empty() {
        return Err(invalid("names no bucket; write s3://BUCKET/FOLDER".into()));
    }
    let key = Key::parse(key).map_err(|e| invalid(e.to_string()))?;
    Ok((bucket.to_owned(), key))
}

/// The client of a bucket, which all threads share.
fn bucket(name: &str) -> object_store::Result<Arc<AmazonS3>> {
    let mut buckets = BUCKETS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = buckets.get(name) {
        return Ok(known.clone());
    }
    let retry = RetryConfig {
        max_retries: usize::MAX,
        retry_timeout: RETRIED,
        ..RetryConfig::default()
    };
    let named = AmazonS3Builder::from_env().with_bucket_name(name);
    // Not every server removes several objects by one request.
    let builder = named.with_retry(retry).with_disable_bulk_delete(true);
    let bucket = Arc::new(builder.build()?);
    buckets.insert(name.to_owned(), bucket.clone());
    Ok(bucket)
}

/// An error in few words, with what to do.
fn plain(bucket: &str, error: &Error) -> io::Error {
    let text = error.to_string();
    let between = |begin: &str, end: &str| {
        let (_, rest) = text.split_once(begin)?;
        rest.split_once(end).map(|(inner, _)| inner)
    };
    let code = between("<Code>", "</Code>");
    if code == Some("NoSuchBucket") {
        // Not `NotFound`, which only means that an object is not there.
        return io::Error::other(format!("there is no bucket {bucket}"));
    }
    let kind = match error {
        Error::NotFound { .. } => ErrorKind::NotFound,
        Error::PermissionDenied { .. } | Error::Unauthenticated { .. } => {
            ErrorKind::PermissionDenied
        }
        _ => ErrorKind::Other,
    };
    let cause = cause(error);
    let why = match (code, between("<Message>", "</Message>")) {
        (Some(code), Some(message)) => format!("{code}: {message}"),
        _ if text.contains("169.254.169.254") => {
            "no credentials; set AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY".to_owned()
        }
        _ if cause.contains("scheme is not allowed") => {
            "the endpoint is not https; AWS_ALLOW_HTTP=true allows http".to_owned()
        }
        _ if NO_ANSWER.iter().any(|sign| text.contains(sign)) => {
            "the answer is none of S3: a page of the network, or another server".to_owned()
        }
        _ => match url(&text) {
            Some(url) => format!("{url}: {cause}"),
            None => cause,
        },
    };
    io::Error::new(kind, why)
}

/// The method and the address in `Error performing METHOD ADDRESS in SECONDS, ...`.
fn url(text: &str) -> Option<&str> {
    let (_, request) = text.rsplit_once("Error performing ")?;
    request.split_once(" in ").map(|(url, _)| url)
}

/// The first cause of an error.
fn cause(error: &Error) -> String {
    let mut cause: &dyn std::error::Error = error;
    while let Some(source) = cause.source() {
        cause = source;
    }
    cause.to_string()
}
