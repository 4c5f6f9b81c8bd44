//! Functions that differ from PHIDL on purpose, against what PHIDL 1.7.2 draws: `tests/golden`, made by
//! `xtask/golden/arranged.py`.

use pg::text::Justify;
use phidl_core::prelude::*;
use phidl_geometry as pg;
use serde::Deserialize;
use serde::de::DeserializeOwned;

type Corners = [[f64; 2]; 2];

fn read<T: DeserializeOwned>(json: &str) -> Vec<T> {
    serde_json::from_str(json).expect("reference results")
}

fn rect([min, max]: Corners) -> Rect {
    Rect::new(min, max)
}

#[derive(Deserialize)]
struct Packing {
    boxes: Vec<[f64; 2]>,
    params: PackingParams,
    bins: Vec<Corners>,
}

#[derive(Deserialize)]
struct PackingParams {
    spacing: f64,
    max_size: [Option<f64>; 2],
    aspect_ratio: Option<[f64; 2]>,
    sort_by_area: Option<bool>,
}

/// No more bins than PHIDL's, and no larger ones: boxes are rounded up to the packing grid of 10 nm here, PHIDL's are
/// scaled up by 1 % of their spacing.
#[test]
fn bins_are_no_more_and_no_larger_than_the_reference() {
    for case in read::<Packing>(include_str!("../golden/packer.json")) {
        let cells: Vec<Device> = case.boxes.iter().map(|[x, y]| pg::rectangle((*x, *y), 0).unwrap()).collect();
        let [width, height] = case.params.max_size;
        let aspect = case.params.aspect_ratio.unwrap_or([1.0, 1.0]);
        let bins = pg::PackerParams::new(&cells)
            .spacing(case.params.spacing)
            .max_size(pg::arguments::PartialSize { width, height })
            .aspect_ratio((aspect[0], aspect[1]))
            .sort_by_area(case.params.sort_by_area.unwrap_or(true))
            .bins()
            .unwrap();
        assert!(bins.len() <= case.bins.len(), "{} cells", cells.len());
        assert_eq!(bins.iter().map(|bin| bin.references().len()).sum::<usize>(), cells.len());
        let area = |boxes: Vec<Rect>| boxes.iter().map(Rect::area).sum::<f64>();
        let ours = area(bins.iter().map(|bin| bin.bbox().unwrap()).collect());
        let reference = area(case.bins.into_iter().map(rect).collect());
        assert!(ours <= 1.001 * reference, "{} cells in {ours} µm², the reference needs {reference} µm²", cells.len());
    }
}

#[derive(Deserialize)]
struct Fill {
    margin: f64,
    corners: Vec<[f64; 2]>,
}

/// PHIDL measures the margin between pixels of the raster, so it can lose half a cell or keep one too much: cells that
/// differ lie that near to the margin.
#[test]
fn filled_cells_differ_from_the_reference_near_the_margin_only() {
    let mut layout = Device::builder("layout");
    layout.add(pg::circle(30, 2.5, 0).unwrap());
    layout.add(pg::rectangle((50, 8), 1).unwrap().place().moved_by((20, 45)));
    layout.add(pg::cross(40, 6, 0).unwrap().place().moved_by((-60, -35)));
    let layout = layout.build().unwrap();
    // The bars of the cross, the rectangle and the disc, as distances of a cell from them.
    let boxes = [((20.0, 45.0), (70.0, 53.0)), ((-80.0, -38.0), (-40.0, -32.0)), ((-63.0, -55.0), (-57.0, -15.0))];
    let distance = |cell: Rect| -> f64 {
        let gap = |a: Rect, b: Rect| {
            let along = |a0: f64, a1: f64, b0: f64, b1: f64| (b0 - a1).max(a0 - b1).max(0.0);
            along(a.min.x, a.max.x, b.min.x, b.max.x).hypot(along(a.min.y, a.max.y, b.min.y, b.max.y))
        };
        let nearest = Point::new(0.0_f64.clamp(cell.min.x, cell.max.x), 0.0_f64.clamp(cell.min.y, cell.max.y));
        boxes.iter().map(|(a, b)| gap(cell, Rect::new(*a, *b))).fold(nearest.norm() - 30.0, f64::min)
    };
    for case in read::<Fill>(include_str!("../golden/fill.json")) {
        let fill = pg::FillRectangleParams::new(&layout)
            .fill_size((5, 4))
            .margin(case.margin)
            .fill_layers(7)
            .fill_densities(1)
            .bbox([(-100, -80), (100, 80)])
            .build()
            .unwrap();
        let ours: Vec<Rect> = fill.flat_polygons().filter_map(|cell| cell.bbox()).collect();
        assert!(ours.iter().all(|cell| distance(*cell) >= case.margin - 1e-9), "margin {}", case.margin);
        let theirs: Vec<Rect> = case.corners.iter().map(|[x, y]| Rect::new((*x, *y), (x + 5.0, y + 4.0))).collect();
        let among = |cell: &Rect, cells: &[Rect]| cells.iter().any(|other| cell.min.distance(other.min) < 1e-6);
        let only = ours.iter().filter(|cell| !among(cell, &theirs)).chain(theirs.iter().filter(|c| !among(c, &ours)));
        let diagonal = 5.0_f64.hypot(4.0);
        for cell in only {
            let off = distance(*cell) - case.margin;
            assert!(off.abs() <= diagonal, "margin {}: {cell:?} is {off} µm from it", case.margin);
        }
        let (ours, theirs) = (ours.len() as f64, theirs.len() as f64);
        assert!((ours / theirs - 1.0).abs() < 0.12, "margin {}: {ours} cells, the reference has {theirs}", case.margin);
    }
}

#[derive(Deserialize)]
struct Letters {
    text: String,
    polygons: Option<usize>,
    justify: Option<String>,
    bbox: Corners,
}

/// The letters of DEPLOF are our own; their ink has the boxes of the reference's.
#[test]
fn every_letter_and_line_has_the_box_of_the_reference() {
    for case in read::<Letters>(include_str!("../golden/letters.json")) {
        let justify = match case.justify.as_deref() {
            Some("center") => Justify::Center,
            Some("right") => Justify::Right,
            _ => Justify::Left,
        };
        let d = pg::text(case.text.as_str(), 100, justify, 0, "DEPLOF").unwrap();
        let (ours, theirs) = (d.bbox().unwrap(), rect(case.bbox));
        let near = ours.min.distance(theirs.min) < 1e-6 && ours.max.distance(theirs.max) < 1e-6;
        assert!(near, "{:?}: {ours:?}, the reference has {theirs:?}", case.text);
        assert!(case.polygons.is_none_or(|polygons| d.polygons().len() == polygons), "{:?}", case.text);
    }
}
