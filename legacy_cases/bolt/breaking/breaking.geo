<?xml version="1.0" standalone="no"?>
<!DOCTYPE DDA SYSTEM "geometry.dtd">
<Berkeley:DDA xmlns:Berkeley="http://www.tsoft.com/~bdoolin/dda">
<!-- geometry -->
<Berkeley:Geometry>
<Berkeley:Edgenodedist distance="0.01"/>
<Jointlist>
<Joint type="1"> 0 4.99 0 6.01 </Joint>
<Joint type="1"> 3 4.99 3 6.01 </Joint>
<Joint type="1"> -0.01 5 3.01 5 </Joint>
<Joint type="1"> -0.01 6 3.01 6 </Joint>
<Joint type="1"> 0.5 0.99 0.5 2.01 </Joint>
<Joint type="1"> 2.5 0.99 2.5 2.01 </Joint>
<Joint type="1"> 0.49 1 2.51 1 </Joint>
<Joint type="1"> 0.49 2 2.51 2 </Joint>
</Jointlist>
<Boltlist>
<Bolt type="1"> 1 5.5 1 1.5 </Bolt>
<Bolt type="1"> 2 1.5 2 5.5 </Bolt>
</Boltlist>
<Fixedpointlist>
<Point> 0.2 5.5 </Point>
<Point> 2.8 5.5 </Point>
</Fixedpointlist>
</Berkeley:Geometry>
</Berkeley:DDA>
