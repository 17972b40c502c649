//! What cannot be done ends with a sentence and an exit code, soon, and leaves nothing.

use crate::server::{Port, SERVER};
use crate::{Bench, Done, begin, objects, parts, short};
use std::process::Command;
use std::time::{Duration, Instant};

/// An attempt has 30 s, and is repeated for 30 s.
const LONGEST: Duration = Duration::from_secs(70);

const PAGE: &str = ": the answer is none of S3: a page of the network, or another server\n";

/// Runs a study with these changes of the command; returns what it says.
#[track_caller]
fn fails(bench: &Bench, port: Port, args: &[&str], change: impl Fn(&mut Command)) -> String {
    let mut command = SERVER.slipgap(bench, port, args);
    change(&mut command);
    let begun = Instant::now();
    let done: Done = command.output().unwrap().into();
    assert!(begun.elapsed() < LONGEST, "{args:?}: {:?}", begun.elapsed());
    assert_eq!(done.code, Some(1), "{args:?}: {done:?}");
    assert_eq!(done.out, "", "{args:?}");
    assert_eq!(done.err.lines().count(), 1, "{args:?}: {done:?}");
    assert!(!bench.path("s3:").exists(), "{args:?}");
    assert_eq!(bench.tree("temporary").len(), 0, "{args:?}");
    done.err
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn a_bucket_that_is_not_there_and_other_mistakes() {
    let bench = begin("errors");
    bench.file("s.json", short("f", 3));
    let to = |out: &'static str| ["run", "s.json", "--out", out];
    let none = |_: &mut Command| ();
    let said = |args: &[&str]| fails(&bench, Port::Good, args, none);
    let bucket = "slipgap: cannot write in folder s3://no-such-bucket/x/s: there is no bucket no-such-bucket\n";
    assert_eq!(said(&to("s3://no-such-bucket/x")), bucket);
    let shard = [&to("s3://no-such-bucket/x")[..], &["--shard", "1/2"]].concat();
    let store =
        "slipgap: cannot read s3://no-such-bucket/x/s/store: there is no bucket no-such-bucket\n";
    assert_eq!(said(&shard), store);
    let merge = ["merge", "s.json", "--out", "s3://no-such-bucket/x"];
    assert_eq!(said(&merge), bucket);
    let segment = said(&to("s3://errors/a/../b"));
    assert!(
        segment.contains("cannot write in folder s3://errors/a/../b/s: "),
        "{segment}"
    );
    let http = fails(&bench, Port::Good, &to("s3://errors"), |command| {
        command.env_remove("AWS_ALLOW_HTTP");
    });
    assert!(
        http.ends_with("the endpoint is not https; AWS_ALLOW_HTTP=true allows http\n"),
        "{http}"
    );
    let half = fails(&bench, Port::Good, &to("s3://errors"), |command| {
        command.env_remove("AWS_SECRET_ACCESS_KEY");
    });
    assert!(half.to_lowercase().contains("secret"), "{half}");
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn without_credentials_or_network_a_command_ends() {
    let bench = begin("network");
    bench.file("s.json", short("f", 3));
    let to = ["run", "s.json", "--out", "s3://network"];
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let said = fails(&bench, Port::Good, &to, |command| {
                command
                    .env_remove("AWS_ACCESS_KEY_ID")
                    .env_remove("AWS_SECRET_ACCESS_KEY");
            });
            assert!(
                said.ends_with(
                    ": no credentials; set AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY\n"
                ),
                "{said}"
            );
        });
        scope.spawn(|| {
            let said = fails(&bench, Port::Good, &to, |command| {
                // The discard port, on which nothing listens.
                command.env("AWS_ENDPOINT_URL", "http://127.0.0.1:9");
            });
            assert!(said.contains("GET http://127.0.0.1:9/network?"), "{said}");
            assert!(
                said.ends_with(": Connection refused (os error 111)\n"),
                "{said}"
            );
        });
        scope.spawn(|| {
            let said = fails(&bench, Port::Good, &to, |command| {
                command.env("AWS_ENDPOINT_URL", "https://no-such-host.invalid");
            });
            assert!(
                said.contains("cannot write in folder s3://network/s: "),
                "{said}"
            );
        });
        scope.spawn(|| {
            let said = fails(&bench, Port::Silent, &to, |_| ());
            assert!(said.contains("timed out"), "{said}");
        });
    });
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn a_page_and_parts_that_are_not_kept_are_no_success() {
    let bench = begin("lost");
    bench.file("s.json", short("f", 3));
    let args = ["run", "s.json", "--shard", "1/1", "--out", "s3://lost"];
    let said = fails(&bench, Port::Page, &args, |_| ());
    assert!(said.ends_with(PAGE), "{said}");
    let said = fails(&bench, Port::Forgetful, &args, |_| ());
    assert!(
        said.starts_with("slipgap: cannot keep s3://lost/s/store/part-"),
        "{said}"
    );
    assert!(
        said.ends_with(
            ": the server does not list it: it did not keep it, or another run has removed it\n"
        ),
        "{said}"
    );
    assert_eq!(objects(&bench, "lost").len(), 0);
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn parts_that_the_server_does_not_give_are_neither_missing_nor_computed_again() {
    let bench = begin("ungiven");
    bench.file("s.json", short("f", 3));
    let out = ["--out", "s3://ungiven"];
    let shard = [&["run", "s.json", "--shard", "1/1"][..], &out].concat();
    SERVER.run(&bench, Port::Good, 0, &shard);
    let before = objects(&bench, "ungiven");
    assert_eq!(parts(&before), 1);
    let status = [&["status", "s.json"][..], &out].concat();
    let merge = [&["merge", "s.json", "--shards", "1"][..], &out].concat();
    std::thread::scope(|scope| {
        for args in [&shard, &status, &merge] {
            scope.spawn(|| {
                let said = fails(&bench, Port::Ungiving, args, |_| ());
                assert!(
                    said.starts_with("slipgap: cannot read s3://ungiven/s/store/part-"),
                    "{said}"
                );
                assert!(said.ends_with(": InternalError: Try again.\n"), "{said}");
            });
        }
    });
    assert_eq!(parts(&objects(&bench, "ungiven")), 1);
    SERVER.run(&bench, Port::Good, 0, &merge);
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn a_page_for_a_part_is_no_damage_and_a_list_without_end_ends() {
    let bench = begin("pages");
    bench.file("s.json", short("f", 3));
    let out = ["--out", "s3://pages"];
    let shard = [&["run", "s.json", "--shard", "1/1"][..], &out].concat();
    SERVER.run(&bench, Port::Good, 0, &shard);
    let status = [&["status", "s.json"][..], &out].concat();
    let merge = [&["merge", "s.json", "--shards", "1"][..], &out].concat();
    for args in [&shard, &status, &merge] {
        let said = fails(&bench, Port::Paging, args, |_| ());
        assert!(said.ends_with(PAGE), "{said}");
        let said = fails(&bench, Port::Repeating, args, |_| ());
        let repeats = ": the server repeats a page of the list of objects\n";
        assert!(said.ends_with(repeats), "{said}");
    }
    assert_eq!(parts(&objects(&bench, "pages")), 1);
    SERVER.run(&bench, Port::Good, 0, &merge);
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn a_run_whose_parts_another_one_removes_is_no_success() {
    let bench = begin("robbed");
    let run = ["run", "s.json", "--out", "s3://robbed"];
    bench.file("s.json", short("f", 3));
    SERVER.run(&bench, Port::Robbing, 0, &run);
    // Its part replaces the former one.
    bench.file("s.json", short("f", 4));
    let said = SERVER.run(&bench, Port::Robbing, 1, &run).err;
    let lost = "\nslipgap: cannot keep s3://robbed/s/store/part-";
    assert!(said.contains(lost), "{said}");
    assert!(said.ends_with("or another run has removed it\n"), "{said}");
    SERVER.run(&bench, Port::Good, 0, &run);
    assert_eq!(parts(&objects(&bench, "robbed")), 1);
}
