use super::{Silent, threads};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

fn started(script: &str) -> Child {
    let mut command = Command::new("sh");
    let piped = command
        .args(["-c", script])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    piped.spawn().unwrap()
}

fn soon() -> Instant {
    Instant::now() + Duration::from_secs(20)
}

/// The same tests of each kind of pipes, since a system has only one.
macro_rules! tests_of {
    ($kind:ident, $pipes:ty) => {
        mod $kind {
            use super::*;

            /// The program, its pipes.
            fn pipes(script: &str) -> (Child, $pipes) {
                let mut child = started(script);
                let pipes = <$pipes>::of(&mut child);
                (child, pipes)
            }

            #[test]
            fn requests_larger_than_a_pipe_come_back_in_their_order() {
                let (mut child, mut pipes) = pipes("cat");
                // Twice: what is left of a request goes before the next one.
                let long = |c: &str| c.repeat(1 << 20) + "\n";
                pipes.send(long("a").into_bytes());
                pipes.send(long("b").into_bytes());
                for c in ["a", "b"] {
                    assert!(pipes.line(soon()).unwrap() == long(c));
                }
                pipes.send(b"short\n".to_vec());
                assert_eq!(pipes.line(soon()).unwrap(), "short\n");
                pipes.end_input();
                assert_eq!(pipes.line(soon()).unwrap_err(), Silent::Ended);
                assert!(child.wait().unwrap().success());
            }

            #[test]
            fn lines_come_one_by_one_and_the_last_one_needs_no_end() {
                let (mut child, mut pipes) = pipes(r"printf 'a\n\nb\377\nc'; echo said >&2");
                for line in ["a\n", "\n", "b\u{fffd}\n", "c"] {
                    assert_eq!(pipes.line(soon()).unwrap(), line);
                }
                assert_eq!(pipes.line(soon()).unwrap_err(), Silent::Ended);
                child.wait().unwrap();
                pipes.keep("kept\n");
                pipes.keep_rest(Duration::from_millis(200));
                let said = pipes.with_tail("why");
                assert!(said.starts_with("why; its last lines: "), "{said}");
                assert!(said.contains("kept") && said.contains("said"), "{said}");
            }

            #[test]
            fn no_program_holds_up_the_product() {
                let (mut child, mut pipes) = pipes("exec sleep 60");
                // It reads nothing.
                pipes.send(vec![b'x'; 1 << 20]);
                let until = Instant::now() + Duration::from_millis(50);
                assert_eq!(pipes.line(until).unwrap_err(), Silent::Late);
                assert!(Instant::now() >= until);
                child.kill().unwrap();
                child.wait().unwrap();
                assert_eq!(pipes.line(soon()).unwrap_err(), Silent::Ended);
                pipes.send(b"more\n".to_vec());
                assert_eq!(pipes.line(soon()).unwrap_err(), Silent::Ended);
            }

            #[test]
            fn what_a_program_prints_at_its_end_does_not_hold_it_up() {
                let (mut child, mut pipes) =
                    pipes("cat; i=0; while [ $i -lt 9000 ]; do echo 'more and more'; i=$((i + 1)); done; echo last");
                pipes.end_input();
                pipes.keep_rest(Duration::from_secs(20));
                assert!(child.wait().unwrap().success());
                assert!(pipes.with_tail("").ends_with("| last"));
            }
        }
    };
}

tests_of!(without_threads, crate::programs::pipes::poll::Pipes);
tests_of!(with_threads, threads::Pipes);
