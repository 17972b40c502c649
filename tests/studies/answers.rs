//! Words and speeds of docs/answers.md. Its other numbers are compared with tables of the evidence: tests/repository/fresh.

const PAGE: &str = include_str!("../../docs/answers.md");

#[track_caller]
fn says(piece: &str) {
    assert!(PAGE.contains(piece), "not on the page: {piece}");
}

#[test]
fn speed_is_that_of_the_page_of_speed() {
    says("10⁷ collisions of bars (n = 10, 300 steps) take 18 s of one processor");
    says("9 to 99 degrees of freedom 133 to 266 ns");
    let page = include_str!("../../docs/performance.md");
    // ns for a step of a case, of a whole run.
    let whole = |problem: &str| -> f64 {
        let row = page.lines().find(|line| line.starts_with(problem));
        row.unwrap()
            .split('|')
            .nth(4)
            .unwrap()
            .trim()
            .parse()
            .unwrap()
    };
    let seconds = whole("| pairs of bars, 10 elements |") * 300.0 * 1e7 / 1e9;
    assert!((seconds - 18.0).abs() < 0.5, "{seconds}");
    let girders = ["9", "99"].map(|size| whole(&format!("| girders, {size} dofs,")));
    assert_eq!(girders, [133.0, 266.0]);
}

#[test]
fn an_answer_has_at_most_150_words_besides_its_block() {
    let mut answers = 0;
    for answer in PAGE.split("\n## ").skip(1) {
        answers += 1;
        let outside = answer.split("```").step_by(2);
        let lines = outside.flat_map(str::lines);
        let words = lines.filter(|line| !line.starts_with("<!--"));
        let count: usize = words.map(|line| line.split_whitespace().count()).sum();
        assert!(count <= 150, "{count} words: {answer}");
        assert!(answer.contains("```"), "no block: {answer}");
    }
    assert_eq!(answers, 11);
    assert!(PAGE.split_whitespace().count() <= 1500);
}
