//! Half of the detector: the rows, each longer than the one above, and a turn between two of them.

use phidl_core::prelude::*;

use super::parts::Wire;

/// More rows than this are taken for a mistake.
const MOST_ROWS: f64 = 1e5;
/// Largest gap that is not filled (µm): floating-point noise of placement.
const SMALLEST_GAP: f64 = 1e-9;

impl Wire {
    /// The upper half: from the terminal down to half of the longest row, which lies on y = 0.
    pub(super) fn half(&self, check: Check<'_>, haxis: f64, vaxis: f64, equalize: f64) -> Result<Device> {
        let turn = self.turn(0.0)?;
        let longest = haxis - 2.0 * turn.size().width;
        let growth = (turn.port("1")?.midpoint().x - turn.port("2")?.midpoint().x).abs() + self.pitch;
        check.greater("haxis", haxis, ("two turns and a step of the rows", haxis - longest + growth))?;
        check.at_most("number of rows", longest / growth, MOST_ROWS)?;
        let first = self.first_bar_length(longest, growth, vaxis);

        let mut d = Device::builder("snspd_candelabra");
        let mut bend = self.terminal_bend()?;
        let to_axis = -bend.port("1")?.midpoint().x;
        bend.move_by((to_axis, 0.0));
        let mut bar = self.bar(first)?;
        bar.connect("W", &bend.port("2")?)?;
        let (bend, bar) = (d.add(bend), d.add(bar));

        // Each row ends in a turn that leads to the next one, longer and one pitch further down.
        let mut length = 2.0 * d.size(..).width - self.width;
        let least = ("the shortest one and a step (a larger haxis or vaxis)", length + growth);
        check.unit("µm").greater("longest row", longest, least)?;
        let mut pad = longest - length - growth;
        let mut end = d[bar].port("E")?;
        let mut left = false;
        loop {
            let turn = if equalize > 0.0 { self.turn(pad * equalize)? } else { turn.clone() };
            let mut turn = if left { turn.place().mirrored((0, 0), (0, 1)) } else { turn.place() };
            turn.connect("1", &end)?;
            end = turn.port("2")?;
            d.add(turn);
            left = !left;
            pad -= growth;
            if length >= longest - growth {
                break;
            }
            length += growth;
            end = self.add_row(&mut d, length, left, &end)?;
        }
        let end = self.add_row(&mut d, length / 2.0, left, &end)?;
        d.add_port("2", end)?;
        self.center(&mut d, bend, bar)?;
        d.build()
    }

    /// Adds a row that begins at `start`, from the right to the left if the last turn was on the right.
    fn add_row(&self, d: &mut DeviceBuilder, length: f64, left: bool, start: &Port) -> Result<Port> {
        let (near, far) = if left { ("E", "W") } else { ("W", "E") };
        let mut row = self.bar(length)?;
        row.connect(near, start)?;
        let end = row.port(far)?;
        d.add(row);
        Ok(end)
    }

    /// Half of what is left for the first row when as many rows as wanted, or as fit, grow by their steps.
    fn first_bar_length(&self, longest: f64, growth: f64, vaxis: f64) -> f64 {
        let wanted = (vaxis / (2.0 * self.pitch)).ceil() + 2.0;
        let mut steps = wanted.min((longest / growth).floor() + 1.0);
        while longest - growth * steps <= 0.0 {
            steps -= 1.0;
        }
        (longest - growth * steps) / 2.0
    }

    /// Centers the rows on x = 0 and puts the terminal there, and the last row on y = 0.
    fn center(&self, d: &mut DeviceBuilder, bend: ReferenceKey, bar: ReferenceKey) -> Result<()> {
        d.set_x(.., 0.0);
        if !self.xwing {
            let off = d[bend].port("1")?.midpoint().x;
            d[bend].movex(-off);
        }
        let bar = d[bar].port("W")?;
        let gap = bar.midpoint().x - d[bend].port("2")?.midpoint().x;
        if gap > SMALLEST_GAP {
            let mut filler = self.bar(gap)?;
            filler.connect("E", &bar)?;
            d.add(filler);
        }
        let shift = (-d.x(..), -d.ymin(..) - self.width / 2.0);
        d.move_by(.., shift);
        d.add_port("1", d[bend].port("1")?)?;
        Ok(())
    }
}
