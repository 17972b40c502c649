use super::*;
use crate::system::structure::Direction;

fn faults(text: &str) -> ImportFault {
    Matrix::parse(text.as_bytes()).unwrap_err()
}

#[test]
fn the_four_forms_of_a_matrix_give_the_same() {
    let forms = [
        "%%MatrixMarket matrix coordinate real symmetric\n% a remark\n3 3 4\n1 1 2.0\n2 1 -1\n2 2 3e0\n3 3 4\n",
        "%%MatrixMarket matrix coordinate real general\n3 3 5\n1 1 2\n1 2 -1\n2 1 -1\n2 2 3\n3 3 4\n",
        "%%matrixmarket MATRIX array integer symmetric\n3 3\n2\n-1\n0\n3\n0\n4\n",
        "%%MatrixMarket matrix array real general\n\n3 3\n2\n-1\n0\n-1\n3\n0\n0\n0\n4\n",
    ];
    for form in forms {
        let matrix = Matrix::parse(form.as_bytes()).unwrap().matrix;
        let entries = matrix.entries().filter(|(_, value)| *value != 0.0);
        let expected = [((0, 0), 2.0), ((1, 0), -1.0), ((1, 1), 3.0), ((2, 2), 4.0)];
        assert_eq!(entries.collect::<Vec<_>>(), expected, "{form}");
    }
}

#[test]
fn what_is_wrong_with_a_matrix_has_its_line() {
    let general = "%%MatrixMarket matrix coordinate real general\n";
    for (text, line, part) in [
        ("", 1, "must begin with"),
        (
            "%%MatrixMarket matrix coordinate complex general\n",
            1,
            "complex",
        ),
        (
            "%%MatrixMarket matrix coordinate real skew-symmetric\n",
            1,
            "skew-symmetric",
        ),
        (general, 1, "ends before the size"),
        (&format!("{general}2 3 1\n1 1 1\n"), 2, "square"),
        (
            &format!("{general}2 2\n1 1 1\n"),
            2,
            "rows, columns and entries",
        ),
        (&format!("{general}2 2 2\n1 1 1\n3 1 1\n"), 4, "from 1 to 2"),
        (&format!("{general}2 2 2\n1 1 1\n2 1 x\n"), 4, "a number"),
        (&format!("{general}2 2 2\n1 1 1\n1 1 1\n"), 4, "twice"),
        (
            &format!("{general}2 2 3\n1 1 1\n2 2 1\n"),
            4,
            "ends after 2 entries of 3",
        ),
        (
            &format!("{general}2 2 1\n1 1 1\n2 2 1\n"),
            4,
            "more entries than the 1",
        ),
        (
            &format!("{general}2 2 3\n1 1 1\n1 2 1\n2 2 1\n"),
            4,
            "not symmetric",
        ),
        (
            "%%MatrixMarket matrix array real symmetric\n18446744073709551615 18446744073709551615\n1\n",
            2,
            "1 to 1000000 rows",
        ),
        (
            "%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n1 2 1\n",
            3,
            "on and below",
        ),
    ] {
        let fault = faults(text);
        assert!(
            fault.line == line && fault.message.contains(part),
            "{text}: {fault}"
        );
    }
}

#[test]
fn a_difference_of_round_off_is_symmetric() {
    let text = "%%MatrixMarket matrix coordinate real general\n2 2 4\n1 1 1e3\n1 2 1\n2 1 1.0000005\n2 2 5\n";
    let matrix = Matrix::parse(text.as_bytes()).unwrap().matrix;
    let entry = matrix.entries().nth(1).unwrap();
    assert_eq!(entry, ((1, 0), 0.5 * 1.0 + 0.5 * 1.0000005));
}

#[test]
fn a_negative_pivot_has_its_line_and_a_free_body_has_none() {
    let spring = |k: f64| {
        format!(
            "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 {k}\n2 1 {}\n2 2 1\n",
            -k.abs()
        )
    };
    let pivots = |text: &str| {
        let matrix = Matrix::parse(text.as_bytes()).unwrap();
        matrix.check_pivots(|row| format!("row {row}"))
    };
    // Two nodes on one spring: one pivot is 0.
    assert_eq!(pivots(&spring(1.0)), Ok(()));
    let fault = pivots(&spring(-1.0)).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "line 3: the matrix has a negative pivot at row 0"
    );
}

#[test]
fn rows_have_a_node_and_a_direction() {
    let text = "node,direction,support,X,Y,Z\n1,x,left,0,0,0\n1,y,left,0,0,0\n2,x,,1.5,0,0\n2,rz,,1.5,0,0\n";
    let dofs = Dofs::parse(text.as_bytes()).unwrap();
    assert_eq!(
        (dofs.len(), &dofs.supports[..]),
        (4, &["left".to_owned()][..])
    );
    assert_eq!(dofs.row("2.rz"), Some(3));
    assert_eq!(dofs.row("2.y"), None);
    assert_eq!(dofs.name(3), "2.rz");
    assert_eq!(dofs.rows()[0].support, Some(0));
    assert_eq!(dofs.rows()[2].at, Some([1.5, 0.0, 0.0]));
    assert_eq!(dofs.directions("2"), [Direction::X, Direction::Rz]);
}

#[test]
fn what_is_wrong_with_rows_and_faces_has_its_line() {
    for (text, line, part) in [
        ("nodes,direction\n", 1, "header"),
        ("node,direction,direction\n", 1, "header"),
        ("node,direction\n", 1, "no rows"),
        ("node,direction\n1,x\n1\n", 3, "2 cells"),
        ("node,direction\n1,u\n", 2, "x, y, z, rx, ry or rz"),
        ("node,direction\n1.5,x\n", 2, "letters, digits"),
        ("node,direction\n1,x\n1,x\n", 3, "twice, first in line 2"),
        (
            "node,direction,support\n1,x,a\n1,y,b\n",
            3,
            "two supports, a and b",
        ),
        ("node,direction,X,Y,Z\n1,x,a,0,0\n", 2, "a number"),
    ] {
        let fault = Dofs::parse(text.as_bytes()).unwrap_err();
        assert!(
            fault.line == line && fault.message.contains(part),
            "{text}: {fault}"
        );
    }
    let face = pairs(b"name,a,b\nf1,left.3.x:-1,right.1.x:1\nf2,left.4.x:-0.5\n").unwrap();
    assert_eq!(
        face[0].along,
        [("left.3.x".to_owned(), -1.0), ("right.1.x".to_owned(), 1.0)]
    );
    assert_eq!((face.len(), face[1].line), (2, 3));
    for (text, line, part) in [
        ("", 1, "no contacts"),
        ("f1\n", 1, "no dof:factor"),
        ("f1,a.1.x\n", 1, "dof:factor"),
        ("f1,a.1.x:q\n", 1, "a number"),
        ("f1,a.1.x:1,a.1.x:2\n", 1, "twice"),
        ("f1,a.1.x:1\nf1,a.2.x:1\n", 2, "first in line 1"),
    ] {
        let fault = pairs(text.as_bytes()).unwrap_err();
        assert!(
            fault.line == line && fault.message.contains(part),
            "{text}: {fault}"
        );
    }
}
