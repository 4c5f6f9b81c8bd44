use phidl_macros::Choice;

#[derive(Debug, Clone, PartialEq, Choice)]
enum WithFields {
    Point(f64, f64),
    #[choice("point")]
    Other,
}

#[derive(Debug, Clone, PartialEq, Choice)]
struct NoEnum;

#[derive(Debug, Clone, PartialEq, Choice)]
enum Wrong {
    #[choice = "a"]
    A,
    #[choice("b")]
    #[choice("c")]
    B,
}

fn main() {}
