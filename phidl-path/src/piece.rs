//! [`Piece`]: a path, points, or a list of these.

use phidl_core::geom::Point;

use crate::Path;

/// A piece of a path, for [`Path::append`]: a path, points, or a list of pieces, nested to any depth.
///
/// ```
/// # use phidl_path::Path;
/// let (s, l, r) = (Path::straight(10)?, Path::euler(4, 90)?, Path::euler(4, -90)?);
/// let path = Path::of([&s, &l, &s, &r, &s]);
/// assert_eq!(path.points().len(), 1014);
/// # Ok::<(), phidl_core::Error>(())
/// ```
pub trait Piece {
    /// Appends the piece to a path.
    fn append_to(self, path: &mut Path);
}

impl Piece for &Path {
    fn append_to(self, path: &mut Path) {
        path.append_path(self);
    }
}

impl Piece for Path {
    fn append_to(self, path: &mut Path) {
        path.append_path(&self);
    }
}

impl<P: Piece> Piece for Vec<P> {
    fn append_to(self, path: &mut Path) {
        self.into_iter().for_each(|piece| piece.append_to(path));
    }
}

impl<P: Piece, const N: usize> Piece for [P; N] {
    fn append_to(self, path: &mut Path) {
        self.into_iter().for_each(|piece| piece.append_to(path));
    }
}

impl<P: Clone> Piece for &[P]
where
    Vec<P>: Piece,
{
    fn append_to(self, path: &mut Path) {
        self.to_vec().append_to(path);
    }
}

impl Piece for Vec<Point> {
    fn append_to(self, path: &mut Path) {
        match Path::from_points(self) {
            Ok(piece) => path.append_path(&piece),
            Err(error) => path.defer(error),
        }
    }
}

impl<const N: usize> Piece for [Point; N] {
    fn append_to(self, path: &mut Path) {
        self.to_vec().append_to(path);
    }
}

impl<X: Into<f64>, Y: Into<f64>> Piece for Vec<(X, Y)> {
    fn append_to(self, path: &mut Path) {
        self.into_iter().map(Point::from).collect::<Vec<_>>().append_to(path);
    }
}

impl<X: Into<f64>, Y: Into<f64>, const N: usize> Piece for [(X, Y); N] {
    fn append_to(self, path: &mut Path) {
        self.map(Point::from).append_to(path);
    }
}
