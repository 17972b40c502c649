use super::*;
use crate::study::Setting;
use std::process::Command;

/// What bash makes of a word.
fn bash(word: &str) -> Option<String> {
    let mut command = Command::new("bash");
    let output = command.args(["-c", &format!("printf %s {word}")]).output();
    output
        .ok()
        .map(|output| String::from_utf8(output.stdout).unwrap())
}

#[test]
fn bash_reads_every_word_as_it_was() {
    let texts = [
        "a",
        "",
        "a b",
        "it's",
        "$(exit 3) `x` \"y\" \\ ! * ~ #",
        "läuft/ÄÖ",
        "-n",
        "'",
        "a'b'c",
        "JOB",
    ];
    for text in texts {
        let Some(read) = bash(&quoted(text).unwrap()) else {
            eprintln!("no bash: not tested");
            return;
        };
        // printf takes a word that begins with - after its format as it is.
        assert_eq!(read, text);
    }
    assert!(quoted("a\u{1b}[31m").is_err());
}

fn args(requeue: bool) -> SbatchArgs {
    SbatchArgs {
        study: "/home/me/my studies/it's.json".into(),
        out: "/scratch/out".into(),
        limit: MOST_CASES,
        shards: 16,
        time: Some("01:00:00".parse().unwrap()),
        partition: Some("main".into()),
        requeue,
        settings: SettingsArgs {
            set: vec![Setting::new("alpha=[0.1, 1]").unwrap()],
        },
        programs: ProgramsArgs {
            allow_programs: false,
        },
    }
}

#[test]
fn the_values_are_at_the_beginning_and_bash_accepts_the_script() {
    for requeue in [false, true] {
        let script = script(&args(requeue)).unwrap();
        let lines = [
            "name='slipgap-it'\\''s'",
            "arguments=('/home/me/my studies/it'\\''s.json' '--out' '/scratch/out' '--set' 'alpha=[0.1, 1]')",
            &format!("folder='{}'", std::env::current_dir().unwrap().display()),
            "shards=16",
            "options=('--time=01:00:00' '--partition=main')",
        ];
        for line in lines {
            assert!(
                script.lines().any(|script_line| script_line == line),
                "{line}\n{script}"
            );
        }
        assert_eq!(script.contains("--signal=B:USR1@60"), requeue);
        let checked = Command::new("bash").args(["-n", "-c", &script]).output();
        if let Ok(checked) = checked {
            assert!(checked.status.success(), "{checked:?}");
        }
    }
}
