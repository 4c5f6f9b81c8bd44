//! [`ports_to_geometry`] and [`geometry_to_ports`]: ports drawn as polygons and labels, which a GDSII file can hold.
//!
//! A port becomes a triangle, for people, and a label with its name, width and orientation as JSON, from which it comes
//! back. Its position is that of the label, so the triangle can be missing.

use phidl_core::prelude::*;
use phidl_core::scene::Anchor;
use phidl_macros::device;

use crate::connect::compass;

/// How far the triangle of a port points outwards, as a part of its width.
const TIP: f64 = 0.1;
/// How far inside a port its label stands, as a part of its width.
const INSET: f64 = 0.05;
/// Magnification of the label of a port that is 1 µm wide.
const LABEL_SIZE: f64 = 0.04;

/// Draws the ports of a cell and of all cells below, each in its own cell, and removes them as ports.
///
/// ```text
///        ╱╲        a tip of a tenth of the width, outwards
///   ┌───╱──╲───┐
///   │ ["N", …] │   a label, a twentieth of the width inside
/// ```
///
/// [`geometry_to_ports`](fn@geometry_to_ports) makes ports of them again. Notes on a port are not drawn.
///
/// # Ports
/// None.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let pad = pg::compass((4, 2), 1)?;
/// let drawn = pg::ports_to_geometry(&pad, 2)?;
/// assert_eq!((drawn.ports().len(), drawn.labels()[0].text.as_str()), (0, r#"["N", 4.0, 90.0]"#));
/// let again = pg::geometry_to_ports(&drawn, 2)?;
/// assert_eq!(again.port("N")?.midpoint(), pad.port("N")?.midpoint());
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `ports_to_geometry`, but with the width unrounded in the label.
#[device(picture = "docs/ports_to_geometry.svg", example = PortsToGeometryParams::new(compass((4, 2), 1)?))]
pub fn ports_to_geometry(
    /// The original.
    device: Device,
    /// Where the triangles are drawn; the labels have its datatype as their texttype.
    #[default(0)]
    layer: Layer,
) -> Result<Device> {
    device.map_cells(|cell| {
        let ports: Vec<Port> = cell.ports().cloned().collect();
        ports.iter().try_for_each(|port| draw_port(cell, port, layer))
    })
}

/// Makes ports of the labels that [`ports_to_geometry`](fn@ports_to_geometry) has written, in each cell of a hierarchy,
/// and removes these labels and all polygons on their layer. Other labels stay.
///
/// # Ports
/// Those that the labels describe.
///
/// # Errors
/// Two labels of one name in a cell, one whose port is there already, or one with a negative width.
///
/// # Examples
/// See [`ports_to_geometry`](fn@ports_to_geometry).
///
/// # Source
/// Own design, compatible with PHIDL's `geometry_to_ports`, which loses all ports if the layer has a datatype.
#[device(picture = "docs/geometry_to_ports.svg", example = GeometryToPortsParams::new(ports_to_geometry(compass((4, 2), 1)?, 0)?))]
pub fn geometry_to_ports(
    /// The original.
    device: Device,
    /// Where the ports are drawn.
    #[default(0)]
    layer: Layer,
) -> Result<Device> {
    device.map_cells(|cell| {
        let ports: Vec<Port> = cell.labels().filter(|label| label.layer == layer).filter_map(port_of).collect();
        cell.add_ports(ports)?;
        cell.remove_labels(|label| label.layer == layer && port_of(label).is_some());
        cell.remove_polygons(|polygon| polygon.layer == layer);
        Ok(())
    })
}

fn draw_port(cell: &mut DeviceBuilder, port: &Port, layer: Layer) -> Result<()> {
    let (outwards, width) = (port.normal(), port.width());
    let (left, right) = port.endpoints();
    cell.add_polygon([left, right, port.midpoint() + outwards * (TIP * width)], layer)?;
    let transform = Transform {
        x_reflection: false,
        magnification: LABEL_SIZE * width,
        rotation: phidl_core::num::angle::normalized(port.orientation() + 90.0),
        origin: port.midpoint() - outwards * (INSET * width),
    };
    let name = serde_json::Value::from(port.name());
    let text = format!("[{name}, {width:?}, {:?}]", port.orientation());
    cell.add(Label::new(text, (0, 0), layer).anchored(Anchor::Center).with_transform(transform));
    cell.remove_port(port.name())?;
    Ok(())
}

/// The port that a label describes, if it does.
fn port_of(label: &Label) -> Option<Port> {
    let (name, width, orientation): (String, f64, f64) = serde_json::from_str(&label.text).ok()?;
    let outwards = Point::polar(1.0, orientation);
    Some(Port::new(label.position() + outwards * (INSET * width), width, orientation).named(name))
}
