"use strict";(()=>{function Df(i,t,e){for(let[n,s]of Object.entries(t))typeof s=="function"?i.addEventListener(n,s):s!=null&&s!==!1&&i.setAttribute(n,s===!0?"":String(s));return i.append(...e.filter(n=>n!=null&&n!==!1)),i}var S=(i,t={},...e)=>Df(document.createElement(i),t,e),yt=(i,t={},...e)=>Df(document.createElementNS("http://www.w3.org/2000/svg",i),t,e);function $t(i,t){i.textContent!==t&&(i.textContent=t)}var $0="\u2212",me=(i,t)=>{let e=i.toFixed(t);return/^-0(\.0*)?$/.test(e)?e.slice(1):e.replace("-",$0)},Ta=i=>i.charAt(0).toUpperCase()+i.slice(1),Ea=i=>i==="transfer"?"free motion":i,Yt=(i,t=0)=>`${me(100*i,t)}\u202F%`;function xe(i,t=1){if(i<60)return`${me(i,t)} s`;let e=10**t,n=Math.round(i*e)/e,[s,r]=[Math.floor(n/3600),Math.floor(n/60)%60],o=(n%60).toFixed(t).padStart(t?t+3:2,"0");return s?`${s}:${String(r).padStart(2,"0")}:${o}`:`${r}:${o}`}var q0=0,Aa=()=>`w${++q0}`;var Gn=class{constructor(t=!1,e=256){this.exact=t;this.data=t?new Float64Array(e):new Float32Array(e)}exact;data;length=0;push(t){this.length===this.data.length&&this.reserve(2*this.length),this.data[this.length++]=t}fill(t,e){e>this.data.length&&this.reserve(Math.max(e,2*this.data.length)),e>this.length&&this.data.fill(t,this.length,e),this.length=Math.max(e,this.length)}get last(){return this.length?this.data[this.length-1]:NaN}reserve(t){let e=this.exact?new Float64Array(t):new Float32Array(t);e.set(this.data.subarray(0,this.length)),this.data=e}},mi=16,zr=class extends Gn{levels=[];least=1/0;largest=-1/0;push(t){super.push(t),t<this.least&&(this.least=t),t>this.largest&&(this.largest=t);let[e,n]=[t,t];for(let s=0,r=mi;this.length%r===0;s++,r*=mi){let o=s===0?null:this.levels[s-1];[e,n]=[1/0,-1/0];for(let l=0;l<mi;l++){let c=o?o.data[o.length-2*mi+2*l]:this.data[this.length-mi+l],h=o?o.data[o.length-2*mi+2*l+1]:c;c<e&&(e=c),h>n&&(n=h)}let a=this.levels[s]??=new Gn(this.exact,64);a.push(e),a.push(n)}}range(t,e){let[n,s]=[1/0,-1/0],r=Math.max(0,t),o=Math.min(e,this.length);for(;r<o;){let[a,l]=[-1,1];for(;r%(l*mi)===0&&r+l*mi<=o&&a+1<this.levels.length;)a++,l*=mi;let c=r/l,h=a<0?this.data[r]:this.levels[a].data[2*c],u=a<0?h:this.levels[a].data[2*c+1];h<n&&(n=h),u>s&&(s=u),r+=l}return n<=s?[n,s]:null}};function Gr(i,t){let[e,n]=[0,i];for(;e<n;){let s=e+n>>1;t(s)?e=s+1:n=s}return e-1}var Ni=(i,t,e=i.length)=>Gr(e,n=>i[n]<=t),Je=i=>typeof i=="number"?i:NaN;var Pa=1e4,Ra=32,Ve=i=>Float32Array.from(i,t=>Je(t)/Pa),Ca=class{constructor(t){this.steps=t;this.times=t.map(([s])=>Je(s));let e=new Float32Array,n=0;t.forEach((s,r)=>{e=Nf(e,s),n=Math.max(n,e.length),r%Ra===0&&this.snapshots.push(e)}),this.most=n}steps;times;snapshots=[];index=-1;now=new Float32Array;most;stepAt(t){return Ni(this.times,t)}places(t){if(t<0||!this.steps.length)return new Float32Array;if(t===this.index)return this.now;let e=Math.floor(t/Ra),n=this.index>=0&&this.index<t&&this.index>=e*Ra,s=n?this.now:this.snapshots[e];for(let r=n?this.index+1:e*Ra+1;r<=t;r++)s=Nf(s,this.steps[r]);return this.index=t,this.now=s,s}at(t){return this.places(Math.max(0,this.stepAt(t)))}};function Nf(i,[,t,e]){let n=new Set(t),s=new Float32Array(Math.max(0,i.length-2*n.size)+e.length),r=0;for(let o=0;o<i.length/2;o++)n.has(o)||(s[r++]=i[2*o],s[r++]=i[2*o+1]);for(let o of e)s[r++]=Je(o)/Pa;return r===s.length?s:s.slice(0,r)}var Ia=class{constructor(t){this.record=t;this.times=t.steps.map(([e])=>Je(e))}record;times;index=-1;now=[];at(t){let e=Math.max(0,Ni(this.times,t));if(e===this.index)return this.now;let n=this.index>=0&&this.index<e,s=n?[...this.now]:Array.from({length:this.record.places.length/2},()=>0);for(let r of this.record.steps.slice(n?this.index+1:0,e+1))this.apply(s,r);return this.index=e,this.now=s,s}get first(){return this.at(-1/0)}get last(){return this.at(1/0)}apply(t,[,e,n]){e.forEach((s,r)=>{s<t.length&&(t[s]=Je(n[r])*this.record.step)})}};var Y0=.1,Uf=2,Z0=1,K0=2,J0=.3,Kh=3,Jh=.03,j0=({kind:i,by_hand:t})=>t||/collision/i.test(i),Da=class{constructor(t,e){this.plan=t;this.number=t.round,this.q=Array.from({length:e},()=>new Gn(!1,64)),this.particles=new Ca(t.particles),this.treated=t.treatment?new Ia(t.treatment):null}plan;number;start=0;t=new Gn(!0);q;tool=new Gn;force=new Gn;normal=new zr;height=new zr;particles;treated;interpreted=null;truth=null;observed=null;over=!1;states={key:"",contact:[],pushed:[]};get events(){return this.interpreted?.events??this.plan.events??[]}get count(){return this.t.length}get length(){let t=this.count?this.t.last:0;return this.interpreted?Math.max(this.interpreted.duration,t):this.over&&this.count?t:Math.max(this.plan.duration,t)}get end(){return this.start+this.length}push({t,q:e,tool:n,force:s,normal:r,height:o}){let a=t.length;if(n.length!==7*a||s.length!==3*a||r.length!==a||o.length!==a||Object.values(e).some(h=>h.length!==a))throw new Error("columns of samples differ in length");if(!t.every(Number.isFinite))throw new Error("a time is not finite");let c=this.count;for(let h of t)this.t.push(Math.max(Je(h),this.count?this.t.last:-1/0));this.q.forEach((h,u)=>{let d=e[u];if(d)for(let f of d)h.push(Je(f));else h.fill(c?h.last:0,c+a)});for(let h of n)this.tool.push(Je(h));for(let h of s)this.force.push(Je(h));for(let h of r)this.normal.push(Je(h));for(let h of o)this.height.push(Je(h))}place(t){let e=Math.max(0,Ni(this.t.data,t,this.count)),[n,s]=[this.t.data[e],this.t.data[e+1]];return e+1>=this.count||!(s>n)?[e,0]:[e,Math.min(1,Math.max(0,(t-n)/(s-n)))]}positions(t,e){if(!this.count)return e;let[n,s]=this.place(t);return this.q.forEach(({data:r},o)=>{e[o]=Ns(r[n],r[n+1],s)}),e}toolAt(t){if(!this.count)return null;let[e,n]=this.place(t);return Q0(this.tool.data,e,n)}forceAt(t){if(!this.count)return null;let[e,n]=this.place(t),s=r=>Ns(this.force.data[3*e+r],this.force.data[3*e+3+r],n);return[s(0),s(1),s(2)]}valueAt(t,e){if(!this.count)return null;let[n,s]=this.place(e),r=Ns(t.data[n],t.data[n+1],s);return Number.isFinite(r)?r:null}get firstContact(){return this.plan.phases.find(({contact:t})=>t)?.start??0}growthAt(t){let{growth:e}=this.plan;if(!e.length)return null;let n=e.length-1;for(;n>0&&e[n][0]>t;)n--;let[s,r]=[e[n],e[n+1]];return!r||t<=s[0]||r[0]<=s[0]?s[1]:Ns(s[1],r[1],Math.min(1,(t-s[0])/(r[0]-s[0])))}phaseAt(t){let{phases:e}=this.plan,n=-1;return e.forEach((s,r)=>{s.start<=t+1e-9&&(n=r)}),n}get contacts(){let t=`${this.count} ${this.events.length} ${!!this.interpreted}`;return t!==this.states.key&&(this.states={key:t,...this.classify()}),this.states}contactAt(t){let{contact:e,pushed:n}=this.contacts;return Of(n,t)?"pushed":Of(e,t)?"contact":"none"}get basis(){return`${!!this.interpreted} ${this.touchForce}`}get touchForce(){return Y0*Uf*Math.floor(Math.max(0,this.normal.largest)/Uf)}classify(){let{normal:t,height:e,plan:n,interpreted:s}=this,r=t.least<=t.largest,o=this.touchForce,a=Math.max(J0,.5*o),l=s?.contacts??n.contacts,c=this.events.filter(j0).map(({start:m,end:g})=>[m,g]);if(!this.count||!r){let m=n.phases.filter(({contact:g})=>g).map(({start:g,end:b})=>[g,b]);return{contact:La(l??m),pushed:La(c)}}let h=m=>e.data[m]>Jh,u=m=>Math.hypot(this.force.data[3*m],this.force.data[3*m+1],this.force.data[3*m+2]),d=this.intervals(m=>h(m)&&u(m)>Math.max(K0,o)),x=(!!s?.incidents?l:l?.filter(([m,g])=>(t.range(this.place(m)[0],this.place(g)[0]+2)?.[1]??0)>a))??this.intervals(m=>!h(m)&&t.data[m]>Math.max(Z0,o));return{contact:La(x),pushed:La([...c,...d])}}intervals(t){let e=[],n=0;for(let s=0;s<=this.count;s++)s<this.count&&t(s)||(s-n>=Kh&&e.push([this.t.data[n],this.t.data[s-1]]),n=s+1);return e}};function Of(i,t){let e=Gr(i.length,n=>i[n][0]<=t);return e>=0&&t<=i[e][1]}function La(i){let t=[];for(let[e,n]of[...i].sort((s,r)=>s[0]-r[0])){let s=t.at(-1);s&&e<=s[1]?s[1]=Math.max(s[1],n):t.push([e,n])}return t}var Ns=(i,t,e)=>e>0?i+e*(t-i):i;function Q0(i,t,e){let[n,s]=[7*t,7*t+7],r=Array.from({length:7},(c,h)=>i[n+h]);if(e<=0)return r;let o=0;for(let c=3;c<7;c++)o+=i[n+c]*i[s+c];let a=o<0?-1:1;for(let c=0;c<3;c++)r[c]=Ns(r[c],i[s+c],e);for(let c=3;c<7;c++)r[c]=Ns(r[c],a*i[s+c],e);let l=Math.hypot(r[3],r[4],r[5],r[6])||1;for(let c=3;c<7;c++)r[c]/=l;return r}var ue=i=>typeof i=="string",Rt=i=>typeof i=="number"&&Number.isFinite(i),Qt=i=>t=>Array.isArray(t)&&t.every(i),Ui=i=>Array.isArray(i),as=i=>t=>Array.isArray(t)&&t.length===i&&t.every(Rt),ie=i=>t=>t==null||i(t),ee=i=>t=>typeof t=="object"&&t!==null&&Object.entries(i).every(([e,n])=>n(t[e])),Us=as(7),Vr=as(2),Ff=ee({mean:Rt,low:Rt,high:Rt}),tx=new Map([["box",ee({size:as(3)})],["sphere",ee({radius:Rt})],["mesh",ee({mesh:Rt})],["cylinder",ee({radius:Rt,length:Rt})],["capsule",ee({radius:Rt,length:Rt})]]),Na=i=>ee({pose:Us,kind:ue,color:ie(as(4))})(i)&&tx.get(i.kind)?.(i)===!0,kf=ee({vertices:Qt(Rt),triangles:Qt(Rt)}),ex=i=>ee({radius_m:Rt,axis_rad:Rt})(i)&&i.kind==="cylinder"&&i.radius_m!==0,nx=i=>{if(!ee({points:Qt(Rt),places:Qt(Rt),triangles:Qt(Rt)})(i))return!1;let{kind:t,points:e,places:n,triangles:s}=i,r=e.length/3,o=a=>Number.isInteger(a)&&a>=0&&a<r;return t==="mesh"&&r>0&&n.length===2*r&&s.length>0&&s.length%3===0&&s.every(o)},ix=i=>{if(!ee({radius_m:Rt,half_angle_rad:Rt,axis_rad:Rt})(i))return!1;let{kind:t,radius_m:e,half_angle_rad:n}=i;return t==="cone"&&e!==0&&n>0&&n<Math.PI/2},Bf=i=>ex(i)||ix(i)||nx(i),sx=i=>Bf(i)||ee({kind:ue})(i)&&i.kind==="plane",zf=ee({kind:ue,start:Rt,end:Rt,words:ue}),rx=ee({task:ie(ee({target:Rt})),tool:ee({solid:Na}),meshes:Qt(kf),robot:ie(ee({variables:Qt(ue),links:Qt(ee({shapes:Qt(Na),collision:ie(Qt(Na))})),joints:Qt(ee({parent:Rt,pose:Us,axis:as(3),offset:Rt,terms:Qt(Vr)}))}))}),ox=ee({strategy:ue,chosen:i=>typeof i=="boolean",error:ie(ue),score:ie(Rt),predicted:ie(Rt),lost:ie(Rt),strokes:ie(Rt),in_contact:ie(Rt),duration:ie(Rt)}),ax=1e6,lx=i=>{if(!ee({unit:ue,target:Rt,low:Rt,high:Rt,step:Rt,cell:as(2),places:Qt(Rt),steps:Qt(Ui)})(i))return!1;let{unit:t,low:e,high:n,target:s,places:r,steps:o}=i,a=c=>c.length===3&&Rt(c[0])&&Qt(Rt)(c[1])&&Qt(Rt)(c[2]);return(t==="passes"?[s,e,n].every(Number.isInteger):t==="\xB5m"&&e<n)&&n<=ax&&e>0&&e<=s&&s<=n&&r.length%2===0&&o.every(a)},cx=ee({round:Rt,duration:Rt,root:ie(Us),surface:ee({pose:Us,rings:Qt(Qt(Rt)),shape:ie(Bf)}),scene:Qt(Na),meshes:Qt(kf),goal:ie(i=>ee({kind:ue})(i)&&(i.kind!=="collected"||ee({place:as(2),radius:Rt})(i))),strokes:Qt(Qt(Rt)),phases:Qt(ee({name:ue,start:Rt,end:Rt})),predicted:ie(Rt),growth:Qt(Vr),particles:Qt(i=>Array.isArray(i)&&i.length===3&&Rt(i[0])&&Ui(i[1])&&Ui(i[2])),treatment:ie(lx),why:Qt(ue),considered:ie(Qt(ox)),events:ie(Qt(zf)),contacts:ie(Qt(Vr))}),hx=ee({time:ie(Rt),title:ue,evidence:ue,effect:ue,advice:ue}),ux=ee({round:Rt,duration:Rt,estimate:Ff,by_touch:Ff,verdict:ue,words:Qt(ue),found:ie(Us),events:Qt(zf),contacts:Qt(Vr),incidents:ie(Qt(hx)),particles:Ui,treated:ie(Ui)}),dx=i=>Array.isArray(i)&&ue(i[0])&&ue(i[1])&&ie(Rt)(i[2]),fx={head:rx,round:cx,interpreted:ux,stage:ee({stage:ue,words:ue}),observed:ee({round:Rt,detections:Ui}),truth:ee({round:Rt,performance:ie(Rt),particles:ie(Ui),treated:ie(Ui),pushes:Qt(Vr),surface:ie(Us),shape:ie(sx)}),ended:ee({verdict:ie(ue),badge:ie(ue),story:ee({asked:ue,happened:ue,sure:ue,surer:ue,next:ie(ee({words:ue,command:ie(ue)}))}),facts:Qt(dx)})};function Gf(i){let t=i;if(t?.piece==="judged"){let{felt:e,...n}=t;return{by_touch:e,...n,piece:"interpreted"}}if(t?.piece==="round"&&Array.isArray(t.considered)){let e=t.considered.map(n=>n&&"worth"in n?{score:n.worth,...n}:n);return{...t,considered:e}}return i}function Vf(i){if(typeof i!="object"||i===null)throw new Error("a line is not a piece");let t=fx[i.piece];if(t&&!t(i))throw new Error(`a ${i.piece} piece lacks a field`);i.piece==="head"&&px(i)}function px({robot:i,tool:t}){if(!i)return;let e=i.joints.length+1;if(i.links.length>e||i.joints.some(({parent:n},s)=>!(n>=0&&n<=s)))throw new Error("a joint comes before its parent, or a link has no joint");if(t.link!==null&&!(t.link<e))throw new Error("the link of the tool does not exist")}function Os(i,t){let e=i?.shape??t;return e&&e.kind!=="plane"?e:null}var ti=class i{head=null;rounds=[];stages=[];meshes=[];observedBefore=null;truthBefore=null;ended=null;broken=0;unknown=0;version=0;closed=!1;callbacks=new Set;cachedHappenings=null;static parse(t){let e=new i,n=0;for(;n<t.length;){let s=t.indexOf(`
`,n);s<0&&(s=t.length),e.applyLine(t.slice(n,s)),n=s+1}return e.close(),e}applyLine(t){if(!t.trim())return;let e;try{e=JSON.parse(t)}catch{this.broken++,this.notify(null);return}this.apply(e)}apply(t){try{this.add(t)}catch{this.broken++}this.notify(t)}close(){this.closed=!0;for(let t of this.rounds)t.over=!0;this.layOutRounds(),this.notify(null)}get live(){return!this.closed&&!this.ended}onChange(t){return this.callbacks.add(t),()=>this.callbacks.delete(t)}notify(t){this.version++;for(let e of this.callbacks)e(t)}add(t){let e=Gf(t);switch(Vf(e),e.piece){case"head":this.meshes.push(...e.meshes),this.head=e;break;case"stage":this.stages.push(e);break;case"round":{let n=new Da(e,this.head?.robot?.variables.length??0);this.meshes.push(...e.meshes);let s=this.rounds.at(-1);s&&s.number===n.number&&!s.count&&!s.interpreted?this.rounds.pop():s&&(s.over=!0),this.rounds.push(n),this.layOutRounds();break}case"samples":{let n=this.round(e.round);n.push(e),n!==this.rounds.at(-1)&&this.layOutRounds();break}case"observed":e.round===0?this.observedBefore=e:this.round(e.round).observed=e;break;case"interpreted":this.round(e.round).interpreted={...e},this.layOutRounds();break;case"truth":e.round===0?this.truthBefore=e:this.round(e.round).truth=e;break;case"ended":this.ended=e;for(let n of this.rounds)n.over=!0;this.layOutRounds();break;default:this.unknown++}}round(t){for(let e=this.rounds.length-1;e>=0;e--)if(this.rounds[e].number===t)return this.rounds[e];throw new Error(`no round ${t}`)}layOutRounds(){let t=0;for(let e of this.rounds)e.start=t,t+=e.length}get duration(){return this.rounds.at(-1)?.end??0}get now(){let t=this.rounds.at(-1);return!t||!this.live||t.interpreted||t.plan.kind==="planned"?this.duration:t.start+(t.count?t.t.last:0)}roundAt(t){return this.rounds[Math.max(0,Gr(this.rounds.length,e=>this.rounds[e].start<=t))]??null}at(t){let e=this.roundAt(t);if(!e)return null;let n=Math.min(Math.max(0,t-e.start),e.length),s=e.valueAt(e.normal,n);return{round:e,time:n,normal:s,q:e.count?e.positions(n,new Float64Array(e.q.length)):new Float64Array,tool:e.toolAt(n),force:e.forceAt(n),height:e.valueAt(e.height,n),performance:e.growthAt(n),contact:e.contactAt(n),phase:e.phaseAt(n)}}outcomeAt(t){for(let r=this.rounds.length-1;r>=0;r--){let o=this.rounds[r];if(o.end>t+1e-6||!(o.interpreted||o.truth||o.observed))continue;let a=o.interpreted?.found??o.plan.surface.pose,{shape:l}=o.plan.surface;return{since:o.end,pose:a,actualPose:o.truth?.surface??a,shape:l,actualShape:Os(o.truth,l),estimated:Hr(o.interpreted?.particles),actual:Hr(o.truth?.particles),seen:Hr(o.observed?.detections)}}let[e]=this.rounds;if(!e||!(this.truthBefore||this.observedBefore))return null;let{pose:n,shape:s}=e.plan.surface;return{since:0,pose:n,actualPose:this.truthBefore?.surface??n,shape:s,actualShape:Os(this.truthBefore,s),estimated:null,actual:Hr(this.truthBefore?.particles),seen:Hr(this.observedBefore?.detections)}}endedAt(t){let e=this.rounds.findLastIndex(s=>s.end<=t+1e-6),n=this.rounds[e+1];return n&&t>=n.start+n.firstContact?null:this.rounds[e]??null}resultAt(t){let e=this.endedAt(t);return e?.interpreted?e:null}foundAt(t){return this.rounds.findLast(e=>e.end<=t+1e-6)?.interpreted?.found??null}get happenings(){if(this.cachedHappenings?.version===this.version)return this.cachedHappenings.list;let t=[];for(let{start:e,events:n,truth:s}of this.rounds){for(let r of n)t.push(mx(r,e));for(let[r,o]of s?.pushes??[])t.push({start:e+r,end:e+o,source:"push",kind:"true push",words:"A push in the simulated world.",byHand:!0})}return t.sort((e,n)=>e.start-n.start),this.cachedHappenings={version:this.version,list:t},t}get stops(){let t=[0,this.duration];for(let{start:e,plan:n}of this.rounds){t.push(e);for(let s of n.phases)s.contact&&t.push(e+s.start)}for(let{start:e}of this.happenings)t.push(e);return[...new Set(t)].filter(e=>e<=this.duration).sort((e,n)=>e-n)}},Hr=i=>i?Ve(i):null,mx=({kind:i,start:t,end:e,words:n,by_hand:s},r)=>({start:r+t,end:r+e,source:"event",kind:i,words:n,byHand:s});/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var qi={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Yi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Cp=0,Uu=1,Pp=2;var gs=1,Ip=2,mr=3,Zi=0,hn=1,pn=2,xs=0,gr=1,Ou=2,Fu=3,ku=4,Lp=5;var vs=100,Dp=101,Np=102,Up=103,Op=104,Fp=200,kp=201,Bp=202,zp=203,Bu=204,zu=205,Gp=206,Vp=207,Hp=208,Wp=209,Xp=210,$p=211,qp=212,Yp=213,Zp=214,fl=0,pl=1,ml=2,er=3,gl=4,xl=5,vl=6,yl=7,Jl=0,Kp=1,Jp=2,ai=0,Gu=1,Vu=2,Hu=3,Wu=4,Xu=5,$u=6,qu=7;var Yu=300,ys=301,xr=302,jl=303,Ql=304,nr=1e3,ni=1001,_l=1002,ke=1003,jp=1004;var Ho=1005;var on=1006,tc=1007;var Ti=1008;var mn=1009,Zu=1010,Ku=1011,vr=1012,ec=1013,Yn=1014,Zn=1015,Kn=1016,nc=1017,ic=1018,_s=1020,Ju=35902,ju=35899,Qu=1021,td=1022,Jn=1023,Si=1026,Ei=1027,ed=1028,sc=1029,Ki=1030,rc=1031;var oc=1033,Wo=33776,Xo=33777,$o=33778,qo=33779,ac=35840,lc=35841,cc=35842,hc=35843,uc=36196,dc=37492,fc=37496,pc=37488,mc=37489,Yo=37490,gc=37491,xc=37808,vc=37809,yc=37810,_c=37811,bc=37812,wc=37813,Sc=37814,Mc=37815,Tc=37816,Ec=37817,Ac=37818,Rc=37819,Cc=37820,Pc=37821,Ic=36492,Lc=36494,Dc=36495,Nc=36283,Uc=36284,Zo=36285,Oc=36286;var to=2300,bl=2301,ul=2302,Mu=2303,Tu=2400,Eu=2401,Au=2402;var Qp=3200;var Ko=0,tm=1,Ai="",He="srgb",eo="srgb-linear",no="linear",ae="srgb";var dl=7680;var em=519,nm=512,im=513,sm=514,nd=515,rm=516,om=517,id=518,sd=519,rd=35044;var od="300 es",Dn=2e3,ir=2001;function gx(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function xx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function io(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function am(){let i=io("canvas");return i.style.display="block",i}var Hf={},sr=null;function so(...i){let t="THREE."+i.shift();sr?sr("log",t,...i):console.log(t,...i)}function lm(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function It(...i){i=lm(i);let t="THREE."+i.shift();if(sr)sr("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Ft(...i){i=lm(i);let t="THREE."+i.shift();if(sr)sr("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Kr(...i){let t=i.join(" ");t in Hf||(Hf[t]=!0,It(...i))}function cm(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var hm={[fl]:fl,[ml]:vl,[gl]:gl,[er]:xl,[pl]:pl,[vl]:ml,[yl]:yl,[xl]:er},Xn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},je=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Wf=1234567,js=Math.PI/180,rr=180/Math.PI;function Ri(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(je[i&255]+je[i>>8&255]+je[i>>16&255]+je[i>>24&255]+"-"+je[t&255]+je[t>>8&255]+"-"+je[t>>16&15|64]+je[t>>24&255]+"-"+je[e&63|128]+je[e>>8&255]+"-"+je[e>>16&255]+je[e>>24&255]+je[n&255]+je[n>>8&255]+je[n>>16&255]+je[n>>24&255]).toLowerCase()}function kt(i,t,e){return Math.max(t,Math.min(e,i))}function ad(i,t){return(i%t+t)%t}function vx(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function yx(i,t,e){return i!==t?(e-i)/(t-i):0}function Jr(i,t,e){return(1-e)*i+e*t}function _x(i,t,e,n){return Jr(i,t,1-Math.exp(-e*n))}function bx(i,t=1){return t-Math.abs(ad(i,t*2)-t)}function wx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function Sx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function Mx(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Tx(i,t){return i+Math.random()*(t-i)}function Ex(i){return i*(.5-Math.random())}function Ax(i){i!==void 0&&(Wf=i);let t=Wf+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Rx(i){return i*js}function Cx(i){return i*rr}function Px(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Ix(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function ld(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Lx(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:It("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Fc(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function cd(i,t){if(t.constructor===Float32Array)return i;let e=Fc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function hd(i,t){if(t.constructor===Float32Array)return i;let e=Fc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var yr={DEG2RAD:js,RAD2DEG:rr,generateUUID:Ri,clamp:kt,euclideanModulo:ad,mapLinear:vx,inverseLerp:yx,lerp:Jr,damp:_x,pingpong:bx,smoothstep:wx,smootherstep:Sx,randInt:Mx,randFloat:Tx,randFloatSpread:Ex,seededRandom:Ax,degToRad:Rx,radToDeg:Cx,isPowerOfTwo:Px,ceilPowerOfTwo:Ix,floorPowerOfTwo:ld,setQuaternionFromProperEuler:Lx,normalize:hd,denormalize:cd},ht=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=kt(this.x,t.x,e.x),this.y=kt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=kt(this.x,t,e),this.y=kt(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(kt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(kt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},an=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let b=Math.acos(m),A=Math.sin(b);g=Math.sin(g*b)/A,a=Math.sin(a*b)/A,l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a;let b=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=b,c*=b,h*=b,u*=b}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-a*f,t[e+2]=c*p+h*f+a*d-l*u,t[e+3]=h*p-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:It("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(kt(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},C=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Xf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Xf.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=kt(this.x,t.x,e.x),this.y=kt(this.y,t.y,e.y),this.z=kt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=kt(this.x,t,e),this.y=kt(this.y,t,e),this.z=kt(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(kt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return jh.copy(this).projectOnVector(t),this.sub(jh)}reflect(t){return this.sub(jh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(kt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},jh=new C,Xf=new an,Bt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],x=s[0],m=s[3],g=s[6],b=s[1],A=s[4],y=s[7],E=s[2],M=s[5],v=s[8];return r[0]=o*x+a*b+l*E,r[3]=o*m+a*A+l*M,r[6]=o*g+a*y+l*v,r[1]=c*x+h*b+u*E,r[4]=c*m+h*A+u*M,r[7]=c*g+h*y+u*v,r[2]=d*x+f*b+p*E,r[5]=d*m+f*A+p*M,r[8]=d*g+f*y+p*v,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=e*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=d*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Kr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Qh.makeScale(t,e)),this}rotate(t){return Kr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Qh.makeRotation(-t)),this}translate(t,e){return Kr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Qh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Qh=new Bt,$f=new Bt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),qf=new Bt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Dx(){let i={enabled:!0,workingColorSpace:eo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ae&&(s.r=wi(s.r),s.g=wi(s.g),s.b=wi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ae&&(s.r=Qs(s.r),s.g=Qs(s.g),s.b=Qs(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ai?no:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[eo]:{primaries:t,whitePoint:n,transfer:no,toXYZ:$f,fromXYZ:qf,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:He},outputColorSpaceConfig:{drawingBufferColorSpace:He}},[He]:{primaries:t,whitePoint:n,transfer:ae,toXYZ:$f,fromXYZ:qf,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:He}}}),i}var jt=Dx();function wi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Qs(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Fs,wl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Fs===void 0&&(Fs=io("canvas")),Fs.width=t.width,Fs.height=t.height;let s=Fs.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Fs}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=io("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=wi(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(wi(e[n]/255)*255):e[n]=wi(e[n]);return{data:e,width:t.width,height:t.height}}else return It("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Nx=0,or=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Nx++}),this.uuid=Ri(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(tu(s[o].image)):r.push(tu(s[o]))}else r=tu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function tu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?wl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(It("Texture: Unable to serialize Texture."),{})}var Ux=0,eu=new C,ln=class i extends Xn{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=ni,s=ni,r=on,o=Ti,a=Jn,l=mn,c=i.DEFAULT_ANISOTROPY,h=Ai){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Ux++}),this.uuid=Ri(),this.name="",this.source=new or(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ht(0,0),this.repeat=new ht(1,1),this.center=new ht(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Bt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(eu).x}get height(){return this.source.getSize(eu).y}get depth(){return this.source.getSize(eu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){It(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){It(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Yu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case nr:t.x=t.x-Math.floor(t.x);break;case ni:t.x=t.x<0?0:1;break;case _l:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case nr:t.y=t.y-Math.floor(t.y);break;case ni:t.y=t.y<0?0:1;break;case _l:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ln.DEFAULT_IMAGE=null;ln.DEFAULT_MAPPING=Yu;ln.DEFAULT_ANISOTROPY=1;var le=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,y=(f+1)/2,E=(g+1)/2,M=(h+d)/4,v=(u+x)/4,T=(p+m)/4;return A>y&&A>E?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=M/n,r=v/n):y>E?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=M/s,r=T/s):E<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),n=v/r,s=T/r),this.set(n,s,r,e),this}let b=Math.sqrt((m-p)*(m-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(b)<.001&&(b=1),this.x=(m-p)/b,this.y=(u-x)/b,this.z=(d-h)/b,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=kt(this.x,t.x,e.x),this.y=kt(this.y,t.y,e.y),this.z=kt(this.z,t.z,e.z),this.w=kt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=kt(this.x,t,e),this.y=kt(this.y,t,e),this.z=kt(this.z,t,e),this.w=kt(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(kt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Sl=class extends Xn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:on,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new le(0,0,t,e),this.scissorTest=!1,this.viewport=new le(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ln({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:on,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new or(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},wn=class extends Sl{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ro=class extends ln{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ke,this.minFilter=ke,this.wrapR=ni,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ml=class extends ln{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ke,this.minFilter=ke,this.wrapR=ni,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var te=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,m)}set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/ks.setFromMatrixColumn(t,0).length(),r=1/ks.setFromMatrixColumn(t,1).length(),o=1/ks.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d-x*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*u,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=x-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+x,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Ox,t,Fx)}lookAt(t,e,n){let s=this.elements;return yn.subVectors(t,e),yn.lengthSq()===0&&(yn.z=1),yn.normalize(),Oi.crossVectors(n,yn),Oi.lengthSq()===0&&(Math.abs(n.z)===1?yn.x+=1e-4:yn.z+=1e-4,yn.normalize(),Oi.crossVectors(n,yn)),Oi.normalize(),Ua.crossVectors(yn,Oi),s[0]=Oi.x,s[4]=Ua.x,s[8]=yn.x,s[1]=Oi.y,s[5]=Ua.y,s[9]=yn.y,s[2]=Oi.z,s[6]=Ua.z,s[10]=yn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],x=n[6],m=n[10],g=n[14],b=n[3],A=n[7],y=n[11],E=n[15],M=s[0],v=s[4],T=s[8],N=s[12],P=s[1],U=s[5],F=s[9],G=s[13],L=s[2],H=s[6],$=s[10],W=s[14],et=s[3],X=s[7],Q=s[11],tt=s[15];return r[0]=o*M+a*P+l*L+c*et,r[4]=o*v+a*U+l*H+c*X,r[8]=o*T+a*F+l*$+c*Q,r[12]=o*N+a*G+l*W+c*tt,r[1]=h*M+u*P+d*L+f*et,r[5]=h*v+u*U+d*H+f*X,r[9]=h*T+u*F+d*$+f*Q,r[13]=h*N+u*G+d*W+f*tt,r[2]=p*M+x*P+m*L+g*et,r[6]=p*v+x*U+m*H+g*X,r[10]=p*T+x*F+m*$+g*Q,r[14]=p*N+x*G+m*W+g*tt,r[3]=b*M+A*P+y*L+E*et,r[7]=b*v+A*U+y*H+E*X,r[11]=b*T+A*F+y*$+E*Q,r[15]=b*N+A*G+y*W+E*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],x=t[7],m=t[11],g=t[15],b=l*f-c*d,A=a*f-c*u,y=a*d-l*u,E=o*f-c*h,M=o*d-l*h,v=o*u-a*h;return e*(x*b-m*A+g*y)-n*(p*b-m*E+g*M)+s*(p*A-x*E+g*v)-r*(p*y-x*M+m*v)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],b=e*a-n*o,A=e*l-s*o,y=e*c-r*o,E=n*l-s*a,M=n*c-r*a,v=s*c-r*l,T=h*x-u*p,N=h*m-d*p,P=h*g-f*p,U=u*m-d*x,F=u*g-f*x,G=d*g-f*m,L=b*G-A*F+y*U+E*P-M*N+v*T;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/L;return t[0]=(a*G-l*F+c*U)*H,t[1]=(s*F-n*G-r*U)*H,t[2]=(x*v-m*M+g*E)*H,t[3]=(d*M-u*v-f*E)*H,t[4]=(l*P-o*G-c*N)*H,t[5]=(e*G-s*P+r*N)*H,t[6]=(m*y-p*v-g*A)*H,t[7]=(h*v-d*y+f*A)*H,t[8]=(o*F-a*P+c*T)*H,t[9]=(n*P-e*F-r*T)*H,t[10]=(p*M-x*y+g*b)*H,t[11]=(u*y-h*M-f*b)*H,t[12]=(a*N-o*U-l*T)*H,t[13]=(e*U-n*N+s*T)*H,t[14]=(x*A-p*E-m*b)*H,t[15]=(h*E-u*A+d*b)*H,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,m=o*u,g=a*u,b=l*c,A=l*h,y=l*u,E=n.x,M=n.y,v=n.z;return s[0]=(1-(x+g))*E,s[1]=(f+y)*E,s[2]=(p-A)*E,s[3]=0,s[4]=(f-y)*M,s[5]=(1-(d+g))*M,s[6]=(m+b)*M,s[7]=0,s[8]=(p+A)*v,s[9]=(m-b)*v,s[10]=(1-(d+x))*v,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=ks.set(s[0],s[1],s[2]).length(),a=ks.set(s[4],s[5],s[6]).length(),l=ks.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Vn.copy(this);let c=1/o,h=1/a,u=1/l;return Vn.elements[0]*=c,Vn.elements[1]*=c,Vn.elements[2]*=c,Vn.elements[4]*=h,Vn.elements[5]*=h,Vn.elements[6]*=h,Vn.elements[8]*=u,Vn.elements[9]*=u,Vn.elements[10]*=u,e.setFromRotationMatrix(Vn),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Dn,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===Dn)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===ir)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Dn,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===Dn)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===ir)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},ks=new C,Vn=new te,Ox=new C(0,0,0),Fx=new C(1,1,1),Oi=new C,Ua=new C,yn=new C,Yf=new te,Zf=new an,ii=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(kt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-kt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(kt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-kt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(kt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-kt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:It("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Yf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Yf,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Zf.setFromEuler(this),this.setFromQuaternion(Zf,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ii.DEFAULT_ORDER="XYZ";var oo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},kx=0,Kf=new C,Bs=new an,gi=new te,Oa=new C,Wr=new C,Bx=new C,zx=new an,Jf=new C(1,0,0),jf=new C(0,1,0),Qf=new C(0,0,1),tp={type:"added"},Gx={type:"removed"},zs={type:"childadded",child:null},nu={type:"childremoved",child:null},Be=class i extends Xn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:kx++}),this.uuid=Ri(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new C,e=new ii,n=new an,s=new C(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new te},normalMatrix:{value:new Bt}}),this.matrix=new te,this.matrixWorld=new te,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new oo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Bs.setFromAxisAngle(t,e),this.quaternion.multiply(Bs),this}rotateOnWorldAxis(t,e){return Bs.setFromAxisAngle(t,e),this.quaternion.premultiply(Bs),this}rotateX(t){return this.rotateOnAxis(Jf,t)}rotateY(t){return this.rotateOnAxis(jf,t)}rotateZ(t){return this.rotateOnAxis(Qf,t)}translateOnAxis(t,e){return Kf.copy(t).applyQuaternion(this.quaternion),this.position.add(Kf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Jf,t)}translateY(t){return this.translateOnAxis(jf,t)}translateZ(t){return this.translateOnAxis(Qf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(gi.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Oa.copy(t):Oa.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Wr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?gi.lookAt(Wr,Oa,this.up):gi.lookAt(Oa,Wr,this.up),this.quaternion.setFromRotationMatrix(gi),s&&(gi.extractRotation(s.matrixWorld),Bs.setFromRotationMatrix(gi),this.quaternion.premultiply(Bs.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Ft("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(tp),zs.child=t,this.dispatchEvent(zs),zs.child=null):Ft("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Gx),nu.child=t,this.dispatchEvent(nu),nu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),gi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),gi.multiply(t.parent.matrixWorld)),t.applyMatrix4(gi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(tp),zs.child=t,this.dispatchEvent(zs),zs.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wr,t,Bx),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wr,zx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Be.DEFAULT_UP=new C(0,1,0);Be.DEFAULT_MATRIX_AUTO_UPDATE=!0;Be.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var de=class extends Be{constructor(){super(),this.isGroup=!0,this.type="Group"}},Vx={type:"move"},ar=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new de,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new de,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new C,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new C),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new de,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new C,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new C,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,n),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Vx)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new de;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},um={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Fi={h:0,s:0,l:0},Fa={h:0,s:0,l:0};function iu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Ct=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=He){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,jt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=jt.workingColorSpace){return this.r=t,this.g=e,this.b=n,jt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=jt.workingColorSpace){if(t=ad(t,1),e=kt(e,0,1),n=kt(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=iu(o,r,t+1/3),this.g=iu(o,r,t),this.b=iu(o,r,t-1/3)}return jt.colorSpaceToWorking(this,s),this}setStyle(t,e=He){function n(r){r!==void 0&&parseFloat(r)<1&&It("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:It("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);It("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=He){let n=um[t.toLowerCase()];return n!==void 0?this.setHex(n,e):It("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=wi(t.r),this.g=wi(t.g),this.b=wi(t.b),this}copyLinearToSRGB(t){return this.r=Qs(t.r),this.g=Qs(t.g),this.b=Qs(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=He){return jt.workingToColorSpace(Qe.copy(this),t),Math.round(kt(Qe.r*255,0,255))*65536+Math.round(kt(Qe.g*255,0,255))*256+Math.round(kt(Qe.b*255,0,255))}getHexString(t=He){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=jt.workingColorSpace){jt.workingToColorSpace(Qe.copy(this),e);let n=Qe.r,s=Qe.g,r=Qe.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=jt.workingColorSpace){return jt.workingToColorSpace(Qe.copy(this),e),t.r=Qe.r,t.g=Qe.g,t.b=Qe.b,t}getStyle(t=He){jt.workingToColorSpace(Qe.copy(this),t);let e=Qe.r,n=Qe.g,s=Qe.b;return t!==He?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Fi),this.setHSL(Fi.h+t,Fi.s+e,Fi.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Fi),t.getHSL(Fa);let n=Jr(Fi.h,Fa.h,e),s=Jr(Fi.s,Fa.s,e),r=Jr(Fi.l,Fa.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Qe=new Ct;Ct.NAMES=um;var ao=class extends Be{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ii,this.environmentIntensity=1,this.environmentRotation=new ii,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Hn=new C,xi=new C,su=new C,vi=new C,Gs=new C,Vs=new C,ep=new C,ru=new C,ou=new C,au=new C,lu=new le,cu=new le,hu=new le,bi=class i{constructor(t=new C,e=new C,n=new C){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Hn.subVectors(t,e),s.cross(Hn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Hn.subVectors(s,e),xi.subVectors(n,e),su.subVectors(t,e);let o=Hn.dot(Hn),a=Hn.dot(xi),l=Hn.dot(su),c=xi.dot(xi),h=xi.dot(su),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,vi)===null?!1:vi.x>=0&&vi.y>=0&&vi.x+vi.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,vi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,vi.x),l.addScaledVector(o,vi.y),l.addScaledVector(a,vi.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return lu.setScalar(0),cu.setScalar(0),hu.setScalar(0),lu.fromBufferAttribute(t,e),cu.fromBufferAttribute(t,n),hu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(lu,r.x),o.addScaledVector(cu,r.y),o.addScaledVector(hu,r.z),o}static isFrontFacing(t,e,n,s){return Hn.subVectors(n,e),xi.subVectors(t,e),Hn.cross(xi).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Hn.subVectors(this.c,this.b),xi.subVectors(this.a,this.b),Hn.cross(xi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Gs.subVectors(s,n),Vs.subVectors(r,n),ru.subVectors(t,n);let l=Gs.dot(ru),c=Vs.dot(ru);if(l<=0&&c<=0)return e.copy(n);ou.subVectors(t,s);let h=Gs.dot(ou),u=Vs.dot(ou);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(Gs,o);au.subVectors(t,r);let f=Gs.dot(au),p=Vs.dot(au);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(Vs,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return ep.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(ep,a);let g=1/(m+x+d);return o=x*g,a=d*g,e.copy(n).addScaledVector(Gs,o).addScaledVector(Vs,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},cn=class{constructor(t=new C(1/0,1/0,1/0),e=new C(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Wn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Wn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Wn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Wn):Wn.fromBufferAttribute(r,o),Wn.applyMatrix4(t.matrixWorld),this.expandByPoint(Wn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),ka.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),ka.copy(n.boundingBox)),ka.applyMatrix4(t.matrixWorld),this.union(ka)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Wn),Wn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Xr),Ba.subVectors(this.max,Xr),Hs.subVectors(t.a,Xr),Ws.subVectors(t.b,Xr),Xs.subVectors(t.c,Xr),ki.subVectors(Ws,Hs),Bi.subVectors(Xs,Ws),ls.subVectors(Hs,Xs);let e=[0,-ki.z,ki.y,0,-Bi.z,Bi.y,0,-ls.z,ls.y,ki.z,0,-ki.x,Bi.z,0,-Bi.x,ls.z,0,-ls.x,-ki.y,ki.x,0,-Bi.y,Bi.x,0,-ls.y,ls.x,0];return!uu(e,Hs,Ws,Xs,Ba)||(e=[1,0,0,0,1,0,0,0,1],!uu(e,Hs,Ws,Xs,Ba))?!1:(za.crossVectors(ki,Bi),e=[za.x,za.y,za.z],uu(e,Hs,Ws,Xs,Ba))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Wn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Wn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(yi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),yi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),yi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),yi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),yi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),yi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),yi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),yi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(yi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},yi=[new C,new C,new C,new C,new C,new C,new C,new C],Wn=new C,ka=new cn,Hs=new C,Ws=new C,Xs=new C,ki=new C,Bi=new C,ls=new C,Xr=new C,Ba=new C,za=new C,cs=new C;function uu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){cs.fromArray(i,r);let a=s.x*Math.abs(cs.x)+s.y*Math.abs(cs.y)+s.z*Math.abs(cs.z),l=t.dot(cs),c=e.dot(cs),h=n.dot(cs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Re=new C,Ga=new ht,Hx=0,be=class extends Xn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Hx++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=rd,this.updateRanges=[],this.gpuType=Zn,this.version=0,this._normalizationScale=t!==void 0?Fc(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ga.fromBufferAttribute(this,e),Ga.applyMatrix3(t),this.setXY(e,Ga.x,Ga.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Re.fromBufferAttribute(this,e),Re.applyMatrix3(t),this.setXYZ(e,Re.x,Re.y,Re.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Re.fromBufferAttribute(this,e),Re.applyMatrix4(t),this.setXYZ(e,Re.x,Re.y,Re.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Re.fromBufferAttribute(this,e),Re.applyNormalMatrix(t),this.setXYZ(e,Re.x,Re.y,Re.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Re.fromBufferAttribute(this,e),Re.transformDirection(t),this.setXYZ(e,Re.x,Re.y,Re.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):cd(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):hd(t,this.array)}};var lo=class extends be{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var co=class extends be{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Nt=class extends be{constructor(t,e,n){super(new Float32Array(t),e,n)}},Wx=new cn,$r=new C,du=new C,fn=class{constructor(t=new C,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Wx.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;$r.subVectors(t,this.center);let e=$r.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector($r,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(du.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint($r.copy(t.center).add(du)),this.expandByPoint($r.copy(t.center).sub(du))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Xx=0,Ln=new te,fu=new Be,$s=new C,_n=new cn,qr=new cn,Fe=new C,Ht=class i extends Xn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Xx++}),this.uuid=Ri(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(gx(t)?co:lo)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Bt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ln.makeRotationFromQuaternion(t),this.applyMatrix4(Ln),this}rotateX(t){return Ln.makeRotationX(t),this.applyMatrix4(Ln),this}rotateY(t){return Ln.makeRotationY(t),this.applyMatrix4(Ln),this}rotateZ(t){return Ln.makeRotationZ(t),this.applyMatrix4(Ln),this}translate(t,e,n){return Ln.makeTranslation(t,e,n),this.applyMatrix4(Ln),this}scale(t,e,n){return Ln.makeScale(t,e,n),this.applyMatrix4(Ln),this}lookAt(t){return fu.lookAt(t),fu.updateMatrix(),this.applyMatrix4(fu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter($s).negate(),this.translate($s.x,$s.y,$s.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Nt(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&It("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new cn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ft("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new C(-1/0,-1/0,-1/0),new C(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];_n.setFromBufferAttribute(r),this.morphTargetsRelative?(Fe.addVectors(this.boundingBox.min,_n.min),this.boundingBox.expandByPoint(Fe),Fe.addVectors(this.boundingBox.max,_n.max),this.boundingBox.expandByPoint(Fe)):(this.boundingBox.expandByPoint(_n.min),this.boundingBox.expandByPoint(_n.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ft('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new fn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ft("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new C,1/0);return}if(t){let n=this.boundingSphere.center;if(_n.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];qr.setFromBufferAttribute(a),this.morphTargetsRelative?(Fe.addVectors(_n.min,qr.min),_n.expandByPoint(Fe),Fe.addVectors(_n.max,qr.max),_n.expandByPoint(Fe)):(_n.expandByPoint(qr.min),_n.expandByPoint(qr.max))}_n.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Fe.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Fe));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Fe.fromBufferAttribute(a,c),l&&($s.fromBufferAttribute(t,c),Fe.add($s)),s=Math.max(s,n.distanceToSquared(Fe))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ft('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Ft("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new be(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let N=0;N<n.count;N++)a[N]=new C,l[N]=new C;let h=new C,u=new C,d=new C,f=new ht,p=new ht,x=new ht,m=new C,g=new C;function b(N,P,U){c[N]=c[P]=c[U]=1,h.fromBufferAttribute(n,N),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,U),f.fromBufferAttribute(r,N),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,U),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let F=1/(p.x*x.y-x.x*p.y);isFinite(F)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(F),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(F),a[N].add(m),a[P].add(m),a[U].add(m),l[N].add(g),l[P].add(g),l[U].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let N=0,P=A.length;N<P;++N){let U=A[N],F=U.start,G=U.count;for(let L=F,H=F+G;L<H;L+=3)b(t.getX(L+0),t.getX(L+1),t.getX(L+2))}let y=new C,E=new C,M=new C,v=new C;function T(N){M.fromBufferAttribute(s,N),v.copy(M);let P=a[N];y.copy(P),y.sub(M.multiplyScalar(M.dot(P))).normalize(),E.crossVectors(v,P);let F=E.dot(l[N])<0?-1:1;o.setXYZW(N,y.x,y.y,y.z,F)}for(let N=0,P=n.count;N<P;++N)c[N]&&T(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new be(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new C,r=new C,o=new C,a=new C,l=new C,c=new C,h=new C,u=new C;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Fe.fromBufferAttribute(t,e),Fe.normalize(),t.setXYZ(e,Fe.x,Fe.y,Fe.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new be(d,h,u)}if(this.index===null)return It("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ho=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=rd,this.updateRanges=[],this.version=0,this.uuid=Ri()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=np(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=np(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function np(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Ri()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var sn=new C,We=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?Fc(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)sn.fromBufferAttribute(this,e),sn.applyMatrix4(t),this.setXYZ(e,sn.x,sn.y,sn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)sn.fromBufferAttribute(this,e),sn.applyNormalMatrix(t),this.setXYZ(e,sn.x,sn.y,sn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)sn.fromBufferAttribute(this,e),sn.transformDirection(t),this.setXYZ(e,sn.x,sn.y,sn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){so("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new be(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){so("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):cd(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):hd(t,this.data.array)}},pu=new C,$x=new C,qx=new Bt,bn=class{constructor(t=new C(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=pu.subVectors(n,e).cross($x.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(pu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||qx.getNormalMatrix(t),s=this.coplanarPoint(pu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Yx=0,Nn=class extends Xn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Yx++}),this.uuid=Ri(),this.name="",this.type="Material",this.blending=gr,this.side=Zi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Bu,this.blendDst=zu,this.blendEquation=vs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ct(0,0,0),this.blendAlpha=0,this.depthFunc=er,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=em,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=dl,this.stencilZFail=dl,this.stencilZPass=dl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){It(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){It(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Ct().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new bn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new ht().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ht().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var _i=new C,mu=new C,Va=new C,Ha=new C,si=class{constructor(t=new C,e=new C(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,_i)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=_i.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(_i.copy(this.origin).addScaledVector(this.direction,e),_i.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){mu.copy(t).add(e).multiplyScalar(.5),Va.copy(e).sub(t).normalize(),Ha.copy(this.origin).sub(mu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Va),a=Ha.dot(this.direction),l=-Ha.dot(Va),c=Ha.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(mu).addScaledVector(Va,d),f}intersectSphere(t,e){if(t.radius<0)return null;_i.subVectors(t.center,this.origin);let n=_i.dot(this.direction),s=_i.dot(_i)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,_i)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=n.x-o.x,b=n.y-o.y,A=n.z-o.z,y=Math.abs(l),E=Math.abs(c),M=Math.abs(h),v,T,N,P,U,F,G,L,H,$,W,et;if(y>=E&&y>=M?(N=l,F=u,H=p,et=g,l>=0?(v=c,T=h,P=d,U=f,G=x,L=m,$=b,W=A):(v=h,T=c,P=f,U=d,G=m,L=x,$=A,W=b)):E>=M?(N=c,F=d,H=x,et=b,c>=0?(v=h,T=l,P=f,U=u,G=m,L=p,$=A,W=g):(v=l,T=h,P=u,U=f,G=p,L=m,$=g,W=A)):(N=h,F=f,H=m,et=A,h>=0?(v=l,T=c,P=u,U=d,G=p,L=x,$=g,W=b):(v=c,T=l,P=d,U=u,G=x,L=p,$=b,W=g)),N===0)return null;let X=v/N,Q=T/N,tt=1/N,_t=P-X*F,Ot=U-Q*F,Z=G-X*H,gt=L-Q*H,wt=$-X*et,Lt=W-Q*et,xt=wt*gt-Lt*Z,Vt=_t*Lt-Ot*wt,Ee=Z*Ot-gt*_t;if(s){if(xt<0||Vt<0||Ee<0)return null}else if((xt<0||Vt<0||Ee<0)&&(xt>0||Vt>0||Ee>0))return null;let Ut=xt+Vt+Ee;if(Ut===0)return null;let ce=tt*(xt*F+Vt*H+Ee*et);return(Ut>0?ce<0:ce>0)?null:this.at(ce/Ut,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ri=class extends Nn{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ii,this.combine=Jl,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},ip=new te,hs=new si,Wa=new fn,sp=new C,Xa=new C,$a=new C,qa=new C,gu=new C,Ya=new C,rp=new C,Za=new C,re=class extends Be{constructor(t=new Ht,e=new ri){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ya.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(gu.fromBufferAttribute(u,t),o?Ya.addScaledVector(gu,h):Ya.addScaledVector(gu.sub(e),h))}e.add(Ya)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Wa.copy(n.boundingSphere),Wa.applyMatrix4(r),hs.copy(t.ray).recast(t.near),!(Wa.containsPoint(hs.origin)===!1&&(hs.intersectSphere(Wa,sp)===null||hs.origin.distanceToSquared(sp)>(t.far-t.near)**2))&&(ip.copy(r).invert(),hs.copy(t.ray).applyMatrix4(ip),!(n.boundingBox!==null&&hs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,hs)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],b=Math.max(m.start,f.start),A=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let y=b,E=A;y<E;y+=3){let M=a.getX(y),v=a.getX(y+1),T=a.getX(y+2);s=Ka(this,g,t,n,c,h,u,M,v,T),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let b=a.getX(m),A=a.getX(m+1),y=a.getX(m+2);s=Ka(this,o,t,n,c,h,u,b,A,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],b=Math.max(m.start,f.start),A=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let y=b,E=A;y<E;y+=3){let M=y,v=y+1,T=y+2;s=Ka(this,g,t,n,c,h,u,M,v,T),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let b=m,A=m+1,y=m+2;s=Ka(this,o,t,n,c,h,u,b,A,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Zx(i,t,e,n,s,r,o,a){let l;if(t.side===hn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===Zi,a),l===null)return null;Za.copy(a),Za.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Za);return c<e.near||c>e.far?null:{distance:c,point:Za.clone(),object:i}}function Ka(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Xa),i.getVertexPosition(l,$a),i.getVertexPosition(c,qa);let h=Zx(i,t,e,n,Xa,$a,qa,rp);if(h){let u=new C;bi.getBarycoord(rp,Xa,$a,qa,u),s&&(h.uv=bi.getInterpolatedAttribute(s,a,l,c,u,new ht)),r&&(h.uv1=bi.getInterpolatedAttribute(r,a,l,c,u,new ht)),o&&(h.normal=bi.getInterpolatedAttribute(o,a,l,c,u,new C),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new C,materialIndex:0};bi.getNormal(Xa,$a,qa,d.normal),h.face=d,h.barycoord=u}return h}var Tl=class extends ln{constructor(t=null,e=1,n=1,s,r,o,a,l,c=ke,h=ke,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var us=new fn,Kx=new ht(.5,.5),Ja=new C,Gi=class{constructor(t=new bn,e=new bn,n=new bn,s=new bn,r=new bn,o=new bn){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Dn,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],b=r[12],A=r[13],y=r[14],E=r[15];if(s[0].setComponents(c-o,f-h,g-p,E-b).normalize(),s[1].setComponents(c+o,f+h,g+p,E+b).normalize(),s[2].setComponents(c+a,f+u,g+x,E+A).normalize(),s[3].setComponents(c-a,f-u,g-x,E-A).normalize(),n)s[4].setComponents(l,d,m,y).normalize(),s[5].setComponents(c-l,f-d,g-m,E-y).normalize();else if(s[4].setComponents(c-l,f-d,g-m,E-y).normalize(),e===Dn)s[5].setComponents(c+l,f+d,g+m,E+y).normalize();else if(e===ir)s[5].setComponents(l,d,m,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),us.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),us.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(us)}intersectsSprite(t){us.center.set(0,0,0);let e=Kx.distanceTo(t.center);return us.radius=.7071067811865476+e,us.applyMatrix4(t.matrixWorld),this.intersectsSphere(us)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Ja.x=s.normal.x>0?t.max.x:t.min.x,Ja.y=s.normal.y>0?t.max.y:t.min.y,Ja.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ja)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},op=new te,El=class i{constructor(){this.coordinateSystem=Dn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];op.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Gi),n[s].setFromProjectionMatrix(op,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Gi),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var ds=class extends Nn{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ct(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Al=new C,Rl=new C,ap=new te,Yr=new si,ja=new fn,xu=new C,lp=new C,Cl=class extends Be{constructor(t=new Ht,e=new ds){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Al.fromBufferAttribute(e,s-1),Rl.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Al.distanceTo(Rl);t.setAttribute("lineDistance",new Nt(n,1))}else It("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ja.copy(n.boundingSphere),ja.applyMatrix4(s),ja.radius+=r,t.ray.intersectsSphere(ja)===!1)return;ap.copy(s).invert(),Yr.copy(t.ray).applyMatrix4(ap);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=h.getX(x),b=h.getX(x+1),A=Qa(this,t,Yr,l,g,b,x);A&&e.push(A)}if(this.isLineLoop){let x=h.getX(p-1),m=h.getX(f),g=Qa(this,t,Yr,l,x,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=Qa(this,t,Yr,l,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=Qa(this,t,Yr,l,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Qa(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(Al.fromBufferAttribute(a,s),Rl.fromBufferAttribute(a,r),e.distanceSqToSegment(Al,Rl,xu,lp)>n)return;xu.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(xu);if(!(c<t.near||c>t.far))return{distance:c,point:lp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var cp=new C,hp=new C,lr=class extends Cl{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)cp.fromBufferAttribute(e,s),hp.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+cp.distanceTo(hp);t.setAttribute("lineDistance",new Nt(n,1))}else It("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Un=class extends Nn{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ct(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},up=new te,Ru=new si,tl=new fn,el=new C,$n=class extends Be{constructor(t=new Ht,e=new Un){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),tl.copy(n.boundingSphere),tl.applyMatrix4(s),tl.radius+=r,t.ray.intersectsSphere(tl)===!1)return;up.copy(s).invert(),Ru.copy(t.ray).applyMatrix4(up);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,x=f;p<x;p++){let m=c.getX(p);el.fromBufferAttribute(u,m),dp(el,m,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,x=f;p<x;p++)el.fromBufferAttribute(u,p),dp(el,p,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function dp(i,t,e,n,s,r,o){let a=Ru.distanceSqToPoint(i);if(a<e){let l=new C;Ru.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var uo=class extends ln{constructor(t=[],e=ys,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},oi=class extends ln{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Mi=class extends ln{constructor(t,e,n=Yn,s,r,o,a=ke,l=ke,c,h=Si,u=1){if(h!==Si&&h!==Ei)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new or(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},fo=class extends Mi{constructor(t,e=Yn,n=ys,s,r,o=ke,a=ke,l,c=Si){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},po=class extends ln{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Vi=class i extends Ht{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Nt(c,3)),this.setAttribute("normal",new Nt(h,3)),this.setAttribute("uv",new Nt(u,2));function p(x,m,g,b,A,y,E,M,v,T,N){let P=y/v,U=E/T,F=y/2,G=E/2,L=M/2,H=v+1,$=T+1,W=0,et=0,X=new C;for(let Q=0;Q<$;Q++){let tt=Q*U-G;for(let _t=0;_t<H;_t++){let Ot=_t*P-F;X[x]=Ot*b,X[m]=tt*A,X[g]=L,c.push(X.x,X.y,X.z),X[x]=0,X[m]=0,X[g]=M>0?1:-1,h.push(X.x,X.y,X.z),u.push(_t/v),u.push(1-Q/T),W+=1}}for(let Q=0;Q<T;Q++)for(let tt=0;tt<v;tt++){let _t=d+tt+H*Q,Ot=d+tt+H*(Q+1),Z=d+(tt+1)+H*(Q+1),gt=d+(tt+1)+H*Q;l.push(_t,Ot,gt),l.push(Ot,Z,gt),et+=6}a.addGroup(f,et,N),f+=et,d+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},mo=class i extends Ht{constructor(t=1,e=1,n=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:n,radialSegments:s,heightSegments:r},e=Math.max(0,e),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],h=e/2,u=Math.PI/2*t,d=e,f=2*u+d,p=n*2+r,x=s+1,m=new C,g=new C;for(let b=0;b<=p;b++){let A=0,y=0,E=0,M=0;if(b<=n){let N=b/n,P=N*Math.PI/2;y=-h-t*Math.cos(P),E=t*Math.sin(P),M=-t*Math.cos(P),A=N*u}else if(b<=n+r){let N=(b-n)/r;y=-h+N*e,E=t,M=0,A=u+N*d}else{let N=(b-n-r)/n,P=N*Math.PI/2;y=h+t*Math.sin(P),E=t*Math.cos(P),M=t*Math.sin(P),A=u+d+N*u}let v=Math.max(0,Math.min(1,A/f)),T=0;b===0?T=.5/s:b===p&&(T=-.5/s);for(let N=0;N<=s;N++){let P=N/s,U=P*Math.PI*2,F=Math.sin(U),G=Math.cos(U);g.x=-E*G,g.y=y,g.z=E*F,a.push(g.x,g.y,g.z),m.set(-E*G,M,E*F),m.normalize(),l.push(m.x,m.y,m.z),c.push(P+T,v)}if(b>0){let N=(b-1)*x;for(let P=0;P<s;P++){let U=N+P,F=N+P+1,G=b*x+P,L=b*x+P+1;o.push(U,F,G),o.push(F,L,G)}}}this.setIndex(o),this.setAttribute("position",new Nt(a,3)),this.setAttribute("normal",new Nt(l,3)),this.setAttribute("uv",new Nt(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},cr=class i extends Ht{constructor(t=1,e=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:n,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new C,h=new ht;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=e;u++,d+=3){let f=n+u/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),h.x=(o[d]/t+1)/2,h.y=(o[d+1]/t+1)/2,l.push(h.x,h.y)}for(let u=1;u<=e;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new Nt(o,3)),this.setAttribute("normal",new Nt(a,3)),this.setAttribute("uv",new Nt(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Hi=class i extends Ht{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,x=[],m=n/2,g=0;b(),o===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new Nt(u,3)),this.setAttribute("normal",new Nt(d,3)),this.setAttribute("uv",new Nt(f,2));function b(){let y=new C,E=new C,M=0,v=(e-t)/n;for(let T=0;T<=r;T++){let N=[],P=T/r,U=P*(e-t)+t;for(let F=0;F<=s;F++){let G=F/s,L=G*l+a,H=Math.sin(L),$=Math.cos(L);E.x=U*H,E.y=-P*n+m,E.z=U*$,u.push(E.x,E.y,E.z),y.set(H,v,$).normalize(),d.push(y.x,y.y,y.z),f.push(G,1-P),N.push(p++)}x.push(N)}for(let T=0;T<s;T++)for(let N=0;N<r;N++){let P=x[N][T],U=x[N+1][T],F=x[N+1][T+1],G=x[N][T+1];(t>0||N!==0)&&(h.push(P,U,G),M+=3),(e>0||N!==r-1)&&(h.push(U,F,G),M+=3)}c.addGroup(g,M,0),g+=M}function A(y){let E=p,M=new ht,v=new C,T=0,N=y===!0?t:e,P=y===!0?1:-1;for(let F=1;F<=s;F++)u.push(0,m*P,0),d.push(0,P,0),f.push(.5,.5),p++;let U=p;for(let F=0;F<=s;F++){let L=F/s*l+a,H=Math.cos(L),$=Math.sin(L);v.x=N*$,v.y=m*P,v.z=N*H,u.push(v.x,v.y,v.z),d.push(0,P,0),M.x=H*.5+.5,M.y=$*.5*P+.5,f.push(M.x,M.y),p++}for(let F=0;F<s;F++){let G=E+F,L=U+F;y===!0?h.push(L,L+1,G):h.push(L+1,L,G),T+=3}c.addGroup(g,T,y===!0?1:2),g+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},go=class i extends Hi{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var nl=new C,il=new C,vu=new C,sl=new bi,xo=class extends Ht{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(js*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:x,b:m,c:g}=sl;if(x.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),sl.getNormal(vu),u[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let b=0;b<3;b++){let A=(b+1)%3,y=u[b],E=u[A],M=sl[h[b]],v=sl[h[A]],T=`${y}_${E}`,N=`${E}_${y}`,P=d.get(N);P?(vu.dot(P.normal)<=r&&(f.push(M.x,M.y,M.z),f.push(v.x,v.y,v.z)),d.set(N,null)):d.has(T)||d.set(T,{index0:c[b],index1:c[A],normal:vu.clone()})}}for(let p of d.values())if(p){let{index0:x,index1:m}=p;nl.fromBufferAttribute(a,x),il.fromBufferAttribute(a,m),f.push(nl.x,nl.y,nl.z),f.push(il.x,il.y,il.z)}this.setAttribute("position",new Nt(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},Sn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){It("Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new ht:new C);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new C,s=[],r=[],o=[],a=new C,l=new te;for(let f=0;f<=t;f++){let p=f/t;s[f]=this.getTangentAt(p,new C)}r[0]=new C,o[0]=new C;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(kt(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(kt(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},hr=class extends Sn{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new ht){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Pl=class extends hr{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function ud(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var fp=new C,pp=new C,yu=new ud,_u=new ud,bu=new ud,Il=class extends Sn{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new C){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(pp.subVectors(s[0],s[1]).add(s[0]),c=pp);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(fp.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=fp),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),x=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);x<1e-4&&(x=1),p<1e-4&&(p=x),m<1e-4&&(m=x),yu.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,x,m),_u.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,x,m),bu.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,x,m)}else this.curveType==="catmullrom"&&(yu.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),_u.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),bu.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(yu.calc(l),_u.calc(l),bu.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new C().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function mp(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function Jx(i,t){let e=1-i;return e*e*t}function jx(i,t){return 2*(1-i)*i*t}function Qx(i,t){return i*i*t}function jr(i,t,e,n){return Jx(i,t)+jx(i,e)+Qx(i,n)}function tv(i,t){let e=1-i;return e*e*e*t}function ev(i,t){let e=1-i;return 3*e*e*i*t}function nv(i,t){return 3*(1-i)*i*i*t}function iv(i,t){return i*i*i*t}function Qr(i,t,e,n,s){return tv(i,t)+ev(i,e)+nv(i,n)+iv(i,s)}var vo=class extends Sn{constructor(t=new ht,e=new ht,n=new ht,s=new ht){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new ht){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Qr(t,s.x,r.x,o.x,a.x),Qr(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Ll=class extends Sn{constructor(t=new C,e=new C,n=new C,s=new C){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new C){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Qr(t,s.x,r.x,o.x,a.x),Qr(t,s.y,r.y,o.y,a.y),Qr(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},yo=class extends Sn{constructor(t=new ht,e=new ht){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new ht){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new ht){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Dl=class extends Sn{constructor(t=new C,e=new C){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new C){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new C){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},_o=class extends Sn{constructor(t=new ht,e=new ht,n=new ht){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new ht){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(jr(t,s.x,r.x,o.x),jr(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Nl=class extends Sn{constructor(t=new C,e=new C,n=new C){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new C){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(jr(t,s.x,r.x,o.x),jr(t,s.y,r.y,o.y),jr(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},bo=class extends Sn{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new ht){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(mp(a,l.x,c.x,h.x,u.x),mp(a,l.y,c.y,h.y,u.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new ht().fromArray(s))}return this}},gp=Object.freeze({__proto__:null,ArcCurve:Pl,CatmullRomCurve3:Il,CubicBezierCurve:vo,CubicBezierCurve3:Ll,EllipseCurve:hr,LineCurve:yo,LineCurve3:Dl,QuadraticBezierCurve:_o,QuadraticBezierCurve3:Nl,SplineCurve:bo}),Ul=class extends Sn{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new gp[n](e,t))}return this}getPoint(t,e){let n=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(e.push(h),n=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(new gp[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},wo=class extends Ul{constructor(t){super(),this.type="Path",this.currentPoint=new ht,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let n=new yo(this.currentPoint.clone(),new ht(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){let r=new _o(this.currentPoint.clone(),new ht(t,e),new ht(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){let a=new vo(this.currentPoint.clone(),new ht(t,e),new ht(n,s),new ht(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),n=new bo(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,n,s,r,o,a,l),this}absellipse(t,e,n,s,r,o,a,l){let c=new hr(t,e,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},fs=class extends wo{constructor(t){super(t),this.uuid=Ri(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let n=0,s=this.holes.length;n<s;n++)e[n]=this.holes[n].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,n=this.holes.length;e<n;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(new wo().fromJSON(s))}return this}};function sv(i,t,e=2){let n=t&&t.length,s=n?t[0]*e:i.length,r=dm(i,0,s,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=cv(i,t,r,e)),i.length>80*e){a=i[0],l=i[1];let h=a,u=l;for(let d=e;d<s;d+=e){let f=i[d],p=i[d+1];f<a&&(a=f),p<l&&(l=p),f>h&&(h=f),p>u&&(u=p)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return So(r,o,e,a,l,c,0),o}function dm(i,t,e,n,s){let r;if(s===_v(i,t,e,n)>0)for(let o=t;o<e;o+=n)r=xp(o/n|0,i[o],i[o+1],r);else for(let o=e-n;o>=t;o-=n)r=xp(o/n|0,i[o],i[o+1],r);return r&&ur(r,r.next)&&(To(r),r=r.next),r}function ps(i,t){if(!i)return i;t||(t=i);let e=i,n;do if(n=!1,!e.steiner&&(ur(e,e.next)||Me(e.prev,e,e.next)===0)){if(To(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function So(i,t,e,n,s,r,o){if(!i)return;!o&&r&&pv(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?ov(i,n,s,r):rv(i)){t.push(l.i,i.i,c.i),To(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=av(ps(i),t),So(i,t,e,n,s,r,2)):o===2&&lv(i,t,e,n,s,r):So(ps(i),t,e,n,s,r,1);break}}}function rv(i){let t=i.prev,e=i,n=i.next;if(Me(t,e,n)>=0)return!1;let s=t.x,r=e.x,o=n.x,a=t.y,l=e.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),d=Math.max(s,r,o),f=Math.max(a,l,c),p=n.next;for(;p!==t;){if(p.x>=h&&p.x<=d&&p.y>=u&&p.y<=f&&Zr(s,a,r,l,o,c,p.x,p.y)&&Me(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function ov(i,t,e,n){let s=i.prev,r=i,o=i.next;if(Me(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,d=o.y,f=Math.min(a,l,c),p=Math.min(h,u,d),x=Math.max(a,l,c),m=Math.max(h,u,d),g=Cu(f,p,t,e,n),b=Cu(x,m,t,e,n),A=i.prevZ,y=i.nextZ;for(;A&&A.z>=g&&y&&y.z<=b;){if(A.x>=f&&A.x<=x&&A.y>=p&&A.y<=m&&A!==s&&A!==o&&Zr(a,h,l,u,c,d,A.x,A.y)&&Me(A.prev,A,A.next)>=0||(A=A.prevZ,y.x>=f&&y.x<=x&&y.y>=p&&y.y<=m&&y!==s&&y!==o&&Zr(a,h,l,u,c,d,y.x,y.y)&&Me(y.prev,y,y.next)>=0))return!1;y=y.nextZ}for(;A&&A.z>=g;){if(A.x>=f&&A.x<=x&&A.y>=p&&A.y<=m&&A!==s&&A!==o&&Zr(a,h,l,u,c,d,A.x,A.y)&&Me(A.prev,A,A.next)>=0)return!1;A=A.prevZ}for(;y&&y.z<=b;){if(y.x>=f&&y.x<=x&&y.y>=p&&y.y<=m&&y!==s&&y!==o&&Zr(a,h,l,u,c,d,y.x,y.y)&&Me(y.prev,y,y.next)>=0)return!1;y=y.nextZ}return!0}function av(i,t){let e=i;do{let n=e.prev,s=e.next.next;!ur(n,s)&&pm(n,e,e.next,s)&&Mo(n,s)&&Mo(s,n)&&(t.push(n.i,e.i,s.i),To(e),To(e.next),e=i=s),e=e.next}while(e!==i);return ps(e)}function lv(i,t,e,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&xv(o,a)){let l=mm(o,a);o=ps(o,o.next),l=ps(l,l.next),So(o,t,e,n,s,r,0),So(l,t,e,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function cv(i,t,e,n){let s=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*n,l=r<o-1?t[r+1]*n:i.length,c=dm(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(gv(c))}s.sort(hv);for(let r=0;r<s.length;r++)e=uv(s[r],e);return e}function hv(i,t){let e=i.x-t.x;if(e===0&&(e=i.y-t.y,e===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=n-s}return e}function uv(i,t){let e=dv(i,t);if(!e)return t;let n=mm(e,i);return ps(n,n.next),ps(e,e.next)}function dv(i,t){let e=t,n=i.x,s=i.y,r=-1/0,o;if(ur(i,e))return e;do{if(ur(i,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let u=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(u<=n&&u>r&&(r=u,o=e.x<e.next.x?e:e.next,u===n))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;e=o;do{if(n>=e.x&&e.x>=l&&n!==e.x&&fm(s<c?n:r,s,l,c,s<c?r:n,s,e.x,e.y)){let u=Math.abs(s-e.y)/(n-e.x);Mo(e,i)&&(u<h||u===h&&(e.x>o.x||e.x===o.x&&fv(o,e)))&&(o=e,h=u)}e=e.next}while(e!==a);return o}function fv(i,t){return Me(i.prev,i,t.prev)<0&&Me(t.next,i,i.next)<0}function pv(i,t,e,n){let s=i;do s.z===0&&(s.z=Cu(s.x,s.y,t,e,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,mv(s)}function mv(i){let t,e=1;do{let n=i,s;i=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let c=0;c<e&&(a++,o=o.nextZ,!!o);c++);let l=e;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,e*=2}while(t>1);return i}function Cu(i,t,e,n,s){return i=(i-e)*s|0,t=(t-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,i|t<<1}function gv(i){let t=i,e=i;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==i);return e}function fm(i,t,e,n,s,r,o,a){return(s-o)*(t-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(n-a)}function Zr(i,t,e,n,s,r,o,a){return!(i===o&&t===a)&&fm(i,t,e,n,s,r,o,a)}function xv(i,t){return i.next.i!==t.i&&i.prev.i!==t.i&&!vv(i,t)&&(Mo(i,t)&&Mo(t,i)&&yv(i,t)&&(Me(i.prev,i,t.prev)||Me(i,t.prev,t))||ur(i,t)&&Me(i.prev,i,i.next)>0&&Me(t.prev,t,t.next)>0)}function Me(i,t,e){return(t.y-i.y)*(e.x-t.x)-(t.x-i.x)*(e.y-t.y)}function ur(i,t){return i.x===t.x&&i.y===t.y}function pm(i,t,e,n){let s=ol(Me(i,t,e)),r=ol(Me(i,t,n)),o=ol(Me(e,n,i)),a=ol(Me(e,n,t));return!!(s!==r&&o!==a||s===0&&rl(i,e,t)||r===0&&rl(i,n,t)||o===0&&rl(e,i,n)||a===0&&rl(e,t,n))}function rl(i,t,e){return t.x<=Math.max(i.x,e.x)&&t.x>=Math.min(i.x,e.x)&&t.y<=Math.max(i.y,e.y)&&t.y>=Math.min(i.y,e.y)}function ol(i){return i>0?1:i<0?-1:0}function vv(i,t){let e=i;do{if(e.i!==i.i&&e.next.i!==i.i&&e.i!==t.i&&e.next.i!==t.i&&pm(e,e.next,i,t))return!0;e=e.next}while(e!==i);return!1}function Mo(i,t){return Me(i.prev,i,i.next)<0?Me(i,t,i.next)>=0&&Me(i,i.prev,t)>=0:Me(i,t,i.prev)<0||Me(i,i.next,t)<0}function yv(i,t){let e=i,n=!1,s=(i.x+t.x)/2,r=(i.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==i);return n}function mm(i,t){let e=Pu(i.i,i.x,i.y),n=Pu(t.i,t.x,t.y),s=i.next,r=t.prev;return i.next=t,t.prev=i,e.next=s,s.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function xp(i,t,e,n){let s=Pu(i,t,e);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function To(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function Pu(i,t,e){return{i,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function _v(i,t,e,n){let s=0;for(let r=t,o=e-n;r<e;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var Iu=class{static triangulate(t,e,n=2){return sv(t,e,n)}},tr=class i{static area(t){let e=t.length,n=0;for(let s=e-1,r=0;r<e;s=r++)n+=t[s].x*t[r].y-t[r].x*t[s].y;return n*.5}static isClockWise(t){return i.area(t)<0}static triangulateShape(t,e){let n=[],s=[],r=[];vp(t),yp(n,t);let o=t.length;e.forEach(vp);for(let l=0;l<e.length;l++)s.push(o),o+=e[l].length,yp(n,e[l]);let a=Iu.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function vp(i){let t=i.length;t>2&&i[t-1].equals(i[0])&&i.pop()}function yp(i,t){for(let e=0;e<t.length;e++)i.push(t[e].x),i.push(t[e].y)}var ms=class i extends Ht{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],p=[],x=[],m=[];for(let g=0;g<h;g++){let b=g*d-o;for(let A=0;A<c;A++){let y=A*u-r;p.push(y,-b,0),x.push(0,0,1),m.push(A/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let b=0;b<a;b++){let A=b+c*g,y=b+c*(g+1),E=b+1+c*(g+1),M=b+1+c*g;f.push(A,y,M),f.push(y,E,M)}this.setIndex(f),this.setAttribute("position",new Nt(p,3)),this.setAttribute("normal",new Nt(x,3)),this.setAttribute("uv",new Nt(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}},Eo=class i extends Ht{constructor(t=.5,e=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=t,d=(e-t)/s,f=new C,p=new ht;for(let x=0;x<=s;x++){for(let m=0;m<=n;m++){let g=r+m/n*o;f.x=u*Math.cos(g),f.y=u*Math.sin(g),l.push(f.x,f.y,f.z),c.push(0,0,1),p.x=(f.x/e+1)/2,p.y=(f.y/e+1)/2,h.push(p.x,p.y)}u+=d}for(let x=0;x<s;x++){let m=x*(n+1);for(let g=0;g<n;g++){let b=g+m,A=b,y=b+n+1,E=b+n+2,M=b+1;a.push(A,y,M),a.push(y,E,M)}}this.setIndex(a),this.setAttribute("position",new Nt(l,3)),this.setAttribute("normal",new Nt(c,3)),this.setAttribute("uv",new Nt(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}},Ao=class i extends Ht{constructor(t=new fs([new ht(0,.5),new ht(-.5,-.5),new ht(.5,-.5)]),e=12){super(),this.type="ShapeGeometry",this.parameters={shapes:t,curveSegments:e};let n=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(t)===!1)c(t);else for(let h=0;h<t.length;h++)c(t[h]),this.addGroup(a,l,h),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new Nt(s,3)),this.setAttribute("normal",new Nt(r,3)),this.setAttribute("uv",new Nt(o,2));function c(h){let u=s.length/3,d=h.extractPoints(e),f=d.shape,p=d.holes;tr.isClockWise(f)===!1&&(f=f.reverse());for(let m=0,g=p.length;m<g;m++){let b=p[m];tr.isClockWise(b)===!0&&(p[m]=b.reverse())}let x=tr.triangulateShape(f,p);for(let m=0,g=p.length;m<g;m++){let b=p[m];f=f.concat(b)}for(let m=0,g=f.length;m<g;m++){let b=f[m];s.push(b.x,b.y,0),r.push(0,0,1),o.push(b.x,b.y)}for(let m=0,g=x.length;m<g;m++){let b=x[m],A=b[0]+u,y=b[1]+u,E=b[2]+u;n.push(A,y,E),l+=3}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes;return bv(e,t)}static fromJSON(t,e){let n=[];for(let s=0,r=t.shapes.length;s<r;s++){let o=e[t.shapes[s]];n.push(o)}return new i(n,t.curveSegments)}};function bv(i,t){if(t.shapes=[],Array.isArray(i))for(let e=0,n=i.length;e<n;e++){let s=i[e];t.shapes.push(s.uuid)}else t.shapes.push(i.uuid);return t}var Ro=class i extends Ht{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new C,d=new C,f=[],p=[],x=[],m=[];for(let g=0;g<=n;g++){let b=[],A=g/n,y=o+A*a,E=t*Math.cos(y),M=Math.sqrt(t*t-E*E),v=0;g===0&&o===0?v=.5/e:g===n&&l===Math.PI&&(v=-.5/e);for(let T=0;T<=e;T++){let N=T/e,P=s+N*r;u.x=-M*Math.cos(P),u.y=E,u.z=M*Math.sin(P),p.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),m.push(N+v,1-A),b.push(c++)}h.push(b)}for(let g=0;g<n;g++)for(let b=0;b<e;b++){let A=h[g][b+1],y=h[g][b],E=h[g+1][b],M=h[g+1][b+1];(g!==0||o>0)&&f.push(A,y,M),(g!==n-1||l<Math.PI)&&f.push(y,E,M)}this.setIndex(f),this.setAttribute("position",new Nt(p,3)),this.setAttribute("normal",new Nt(x,3)),this.setAttribute("uv",new Nt(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Co=class i extends Ht{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new C,f=new C,p=new C;for(let x=0;x<=n;x++){let m=o+x/n*a;for(let g=0;g<=s;g++){let b=g/s*r;f.x=(t+e*Math.cos(m))*Math.cos(b),f.y=(t+e*Math.cos(m))*Math.sin(b),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),d.x=t*Math.cos(b),d.y=t*Math.sin(b),p.subVectors(f,d).normalize(),h.push(p.x,p.y,p.z),u.push(g/s),u.push(x/n)}}for(let x=1;x<=n;x++)for(let m=1;m<=s;m++){let g=(s+1)*x+m-1,b=(s+1)*(x-1)+m-1,A=(s+1)*(x-1)+m,y=(s+1)*x+m;l.push(g,b,y),l.push(b,A,y)}this.setIndex(l),this.setAttribute("position",new Nt(c,3)),this.setAttribute("normal",new Nt(h,3)),this.setAttribute("uv",new Nt(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};var Po=class extends Ht{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,s=new C,r=new C;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let u=l[c],d=u.start,f=u.count;for(let p=d,x=d+f;p<x;p+=3)for(let m=0;m<3;m++){let g=a.getX(p+m),b=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,g),r.fromBufferAttribute(o,b),_p(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,u=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),_p(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new Nt(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function _p(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(s)===!0?!1:(e.add(n),e.add(s),!0)}var Io=class extends Nn{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Ct(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function bs(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(bp(s))s.isRenderTargetTexture?(It("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(bp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function tn(i){let t={};for(let e=0;e<i.length;e++){let n=bs(i[e]);for(let s in n)t[s]=n[s]}return t}function bp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function wv(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function dd(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:jt.workingColorSpace}var Jo={clone:bs,merge:tn},Sv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Mv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,On=class extends Nn{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Sv,this.fragmentShader=Mv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=bs(t.uniforms),this.uniformsGroups=wv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Ct().setHex(s.value);break;case"v2":this.uniforms[n].value=new ht().fromArray(s.value);break;case"v3":this.uniforms[n].value=new C().fromArray(s.value);break;case"v4":this.uniforms[n].value=new le().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Bt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new te().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Ol=class extends On{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Lo=class extends Nn{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Ct(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ct(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ko,this.normalScale=new ht(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ii,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Mn=class extends Nn{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ct(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ko,this.normalScale=new ht(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ii,this.combine=Jl,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Fl=class extends Nn{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},kl=class extends Nn{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function qs(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function al(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Wi=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Bl=class extends Wi{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Tu,endingEnd:Tu}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Eu:r=t,a=2*e-n;break;case Au:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Eu:o=t,l=2*n-e;break;case Au:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,b=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,A=(-1-f)*m+(1.5+f)*x+.5*p,y=f*m-f*x;for(let E=0;E!==a;++E)r[E]=g*o[h+E]+b*o[c+E]+A*o[l+E]+y*o[u+E];return r}},zl=class extends Wi{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Gl=class extends Wi{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Vl=class extends Wi{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,b=u[g],A=u[g+1],y=t*d+p*2,E=h[y],M=h[y+1],v=Ev(n,e,b,E,s);r[p]=gm(v,x,A,M,m)}return r}};function gm(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function Tv(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Ev(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=gm(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Tv(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Tn=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=qs(e,this.TimeBufferType),this.values=qs(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:qs(t.times,Array),values:qs(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),al(t.settings)&&(n.settings={inTangents:qs(t.settings.inTangents,Array),outTangents:qs(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Gl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new zl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Bl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Vl(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case to:e=this.InterpolantFactoryMethodDiscrete;break;case bl:e=this.InterpolantFactoryMethodLinear;break;case ul:e=this.InterpolantFactoryMethodSmooth;break;case Mu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return It("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return to;case this.InterpolantFactoryMethodLinear:return bl;case this.InterpolantFactoryMethodSmooth:return ul;case this.InterpolantFactoryMethodBezier:return Mu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;al(this.settings)&&(wp(this.settings.inTangents,t),wp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;al(this.settings)&&(Sp(this.settings.inTangents,t),Sp(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Ft("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Ft("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Ft("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Ft("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&xx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ft("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===ul,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let x=e[u+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,al(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function wp(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Sp(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}Tn.prototype.ValueTypeName="";Tn.prototype.TimeBufferType=Float32Array;Tn.prototype.ValueBufferType=Float32Array;Tn.prototype.DefaultInterpolation=bl;var Xi=class extends Tn{constructor(t,e,n){super(t,e,n)}};Xi.prototype.ValueTypeName="bool";Xi.prototype.ValueBufferType=Array;Xi.prototype.DefaultInterpolation=to;Xi.prototype.InterpolantFactoryMethodLinear=void 0;Xi.prototype.InterpolantFactoryMethodSmooth=void 0;var Hl=class extends Tn{constructor(t,e,n,s){super(t,e,n,s)}};Hl.prototype.ValueTypeName="color";var Wl=class extends Tn{constructor(t,e,n,s){super(t,e,n,s)}};Wl.prototype.ValueTypeName="number";var Xl=class extends Wi{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)an.slerpFlat(r,0,o,c-a,o,c,l);return r}},Do=class extends Tn{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Xl(this.times,this.values,this.getValueSize(),t)}};Do.prototype.ValueTypeName="quaternion";Do.prototype.InterpolantFactoryMethodSmooth=void 0;var $i=class extends Tn{constructor(t,e,n){super(t,e,n)}};$i.prototype.ValueTypeName="string";$i.prototype.ValueBufferType=Array;$i.prototype.DefaultInterpolation=to;$i.prototype.InterpolantFactoryMethodLinear=void 0;$i.prototype.InterpolantFactoryMethodSmooth=void 0;var $l=class extends Tn{constructor(t,e,n,s){super(t,e,n,s)}};$l.prototype.ValueTypeName="vector";var ql=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},xm=new ql,Yl=class{constructor(t){this.manager=t!==void 0?t:xm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Yl.DEFAULT_MATERIAL_NAME="__DEFAULT";var dr=class extends Be{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ct(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},No=class extends dr{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Be.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ct(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},wu=new te,Mp=new C,Tp=new C,Zl=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ht(512,512),this.mapType=mn,this.map=null,this.mapPass=null,this.matrix=new te,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gi,this._frameExtents=new ht(1,1),this._viewportCount=1,this._viewports=[new le(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Mp.setFromMatrixPosition(t.matrixWorld),e.position.copy(Mp),Tp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Tp),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){wu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(wu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===ir||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(wu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},ll=new C,cl=new an,ei=new C,Uo=class extends Be{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new te,this.projectionMatrix=new te,this.projectionMatrixInverse=new te,this.coordinateSystem=Dn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ll,cl,ei),ei.x===1&&ei.y===1&&ei.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ll,cl,ei.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(ll,cl,ei),ei.x===1&&ei.y===1&&ei.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ll,cl,ei.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},zi=new C,Ep=new ht,Ap=new ht,rn=class extends Uo{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=rr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(js*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return rr*2*Math.atan(Math.tan(js*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){zi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(zi.x,zi.y).multiplyScalar(-t/zi.z),zi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(zi.x,zi.y).multiplyScalar(-t/zi.z)}getViewSize(t,e){return this.getViewBounds(t,Ep,Ap),e.subVectors(Ap,Ep)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(js*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Oo=class extends Uo{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Lu=class extends Zl{constructor(){super(new Oo(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Fo=class extends dr{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Be.DEFAULT_UP),this.updateMatrix(),this.target=new Be,this.shadow=new Lu}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},ko=class extends dr{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Bo=class extends Ht{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var Ys=-90,Zs=1,fr=class extends Be{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new rn(Ys,Zs,t,e);s.layers=this.layers,this.add(s);let r=new rn(Ys,Zs,t,e);r.layers=this.layers,this.add(r);let o=new rn(Ys,Zs,t,e);o.layers=this.layers,this.add(o);let a=new rn(Ys,Zs,t,e);a.layers=this.layers,this.add(a);let l=new rn(Ys,Zs,t,e);l.layers=this.layers,this.add(l);let c=new rn(Ys,Zs,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Dn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ir)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Kl=class extends rn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var fd="\\[\\]\\.:\\/",Av=new RegExp("["+fd+"]","g"),pd="[^"+fd+"]",Rv="[^"+fd.replace("\\.","")+"]",Cv=/((?:WC+[\/:])*)/.source.replace("WC",pd),Pv=/(WCOD+)?/.source.replace("WCOD",Rv),Iv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",pd),Lv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",pd),Dv=new RegExp("^"+Cv+Pv+Iv+Lv+"$"),Nv=["material","materials","bones","map"],Du=class{constructor(t,e,n){let s=n||ve.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},ve=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Av,"")}static parseTrackName(t){let e=Dv.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Nv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){It("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){Ft("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Ft("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Ft("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Ft("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Ft("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Ft("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){Ft("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Ft("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Ft("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Ft("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ve.Composite=Du;ve.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ve.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ve.prototype.GetterByBindingType=[ve.prototype._getValue_direct,ve.prototype._getValue_array,ve.prototype._getValue_arrayElement,ve.prototype._getValue_toArray];ve.prototype.SetterByBindingTypeAndVersioning=[[ve.prototype._setValue_direct,ve.prototype._setValue_direct_setNeedsUpdate,ve.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ve.prototype._setValue_array,ve.prototype._setValue_array_setNeedsUpdate,ve.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ve.prototype._setValue_arrayElement,ve.prototype._setValue_arrayElement_setNeedsUpdate,ve.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ve.prototype._setValue_fromArray,ve.prototype._setValue_fromArray_setNeedsUpdate,ve.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var FT=new Float32Array(1);var qn=class extends ho{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var pr=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=kt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(kt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Nu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Rp=new C,hl=new C,Ks=new C,Js=new C,Su=new C,Uv=new C,Ov=new C,zo=class{constructor(t=new C,e=new C){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){Rp.subVectors(t,this.start),hl.subVectors(this.end,this.start);let n=hl.dot(hl);if(n===0)return 0;let r=hl.dot(Rp)/n;return e&&(r=kt(r,0,1)),r}closestPointToPoint(t,e,n){let s=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=Uv,n=Ov){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,h=t.end;Ks.subVectors(c,a),Js.subVectors(h,l),Su.subVectors(a,l);let u=Ks.dot(Ks),d=Js.dot(Js),f=Js.dot(Su);if(u<=s&&d<=s)return e.copy(a),n.copy(l),e.distanceToSquared(n);if(u<=s)r=0,o=f/d,o=kt(o,0,1);else{let p=Ks.dot(Su);if(d<=s)o=0,r=kt(-p/u,0,1);else{let x=Ks.dot(Js),m=u*d-x*x;m!==0?r=kt((x*f-p*d)/m,0,1):r=0,o=(x*r+f)/d,o<0?(o=0,r=kt(-p/u,0,1)):o>1&&(o=1,r=kt((x-p)/u,0,1))}}return e.copy(a).addScaledVector(Ks,r),n.copy(l).addScaledVector(Js,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Go=class extends lr{constructor(t=10,e=10,n=4473924,s=8947848){n=new Ct(n),s=new Ct(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let d=0,f=0,p=-a;d<=e;d++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let x=d===r?n:s;x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3}let h=new Ht;h.setAttribute("position",new Nt(l,3)),h.setAttribute("color",new Nt(c,3));let u=new ds({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Vo=class extends Xn{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function md(i,t,e,n){let s=Fv(n);switch(e){case Qu:return i*t;case ed:return i*t/s.components*s.byteLength;case sc:return i*t/s.components*s.byteLength;case Ki:return i*t*2/s.components*s.byteLength;case rc:return i*t*2/s.components*s.byteLength;case td:return i*t*3/s.components*s.byteLength;case Jn:return i*t*4/s.components*s.byteLength;case oc:return i*t*4/s.components*s.byteLength;case Wo:case Xo:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case $o:case qo:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case lc:case hc:return Math.max(i,16)*Math.max(t,8)/4;case ac:case cc:return Math.max(i,8)*Math.max(t,8)/2;case uc:case dc:case pc:case mc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case fc:case Yo:case gc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case xc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case vc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case yc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case _c:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case bc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case wc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Sc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Mc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Tc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Ec:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ac:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Rc:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Cc:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Pc:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Ic:case Lc:case Dc:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Nc:case Uc:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Zo:case Oc:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Fv(i){switch(i){case mn:case Zu:return{byteLength:1,components:1};case vr:case Ku:case Kn:return{byteLength:2,components:1};case nc:case ic:return{byteLength:2,components:4};case Yn:case ec:case Zn:return{byteLength:4,components:1};case Ju:case ju:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?It("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Bm(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Hv(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Wv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Xv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,$v=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,qv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Yv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Zv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Kv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Jv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,jv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Qv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ty=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ey=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ny=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,iy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,sy=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,ry=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,oy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,ay=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ly=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,cy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,hy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,uy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,dy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,fy=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,py=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,my=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,gy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,xy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,vy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,yy="gl_FragColor = linearToOutputTexel( gl_FragColor );",_y=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,by=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,wy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Sy=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,My=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Ty=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Ey=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ay=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ry=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Cy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Py=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Iy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Ly=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Dy=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Ny=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Uy=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Oy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Fy=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,ky=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,By=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,zy=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Gy=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Vy=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Hy=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Wy=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Xy=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,$y=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,qy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Yy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Zy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ky=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Jy=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,jy=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Qy=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,t_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,e_=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,n_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,i_=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,s_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,r_=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,o_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,a_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,l_=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,c_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,h_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,u_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,d_=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,f_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,p_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,m_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,g_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,x_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,v_=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,y_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,__=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,b_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,w_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,S_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,M_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,T_=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,E_=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,A_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,R_=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,C_=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,P_=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,I_=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,L_=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,D_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,N_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,U_=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,O_=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,F_=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,k_=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,B_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,z_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,G_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,V_=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,H_=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,W_=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,X_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$_=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,q_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Y_=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Z_=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,K_=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,J_=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,j_=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Q_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,tb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eb=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,nb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ib=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,sb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rb=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ob=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ab=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,lb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,cb=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,hb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,ub=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,db=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,pb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mb=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,gb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,vb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,yb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,_b=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,bb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,wb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,qt={alphahash_fragment:Wv,alphahash_pars_fragment:Xv,alphamap_fragment:$v,alphamap_pars_fragment:qv,alphatest_fragment:Yv,alphatest_pars_fragment:Zv,aomap_fragment:Kv,aomap_pars_fragment:Jv,batching_pars_vertex:jv,batching_vertex:Qv,begin_vertex:ty,beginnormal_vertex:ey,bsdfs:ny,iridescence_fragment:iy,bumpmap_pars_fragment:sy,clipping_planes_fragment:ry,clipping_planes_pars_fragment:oy,clipping_planes_pars_vertex:ay,clipping_planes_vertex:ly,color_fragment:cy,color_pars_fragment:hy,color_pars_vertex:uy,color_vertex:dy,common:fy,defaultnormal_vertex:py,displacementmap_pars_vertex:my,displacementmap_vertex:gy,emissivemap_fragment:xy,emissivemap_pars_fragment:vy,colorspace_fragment:yy,colorspace_pars_fragment:_y,envmap_fragment:by,envmap_common_pars_fragment:wy,envmap_pars_fragment:Sy,envmap_pars_vertex:My,envmap_physical_pars_fragment:Uy,envmap_vertex:Ty,fog_vertex:Ey,fog_pars_vertex:Ay,fog_fragment:Ry,fog_pars_fragment:Cy,gradientmap_pars_fragment:Py,lightmap_pars_fragment:Iy,lights_lambert_fragment:Ly,lights_lambert_pars_fragment:Dy,lights_pars_begin:Ny,lights_toon_fragment:Oy,lights_toon_pars_fragment:Fy,lights_phong_fragment:ky,lights_phong_pars_fragment:By,lights_physical_fragment:zy,lights_physical_pars_fragment:Gy,lights_fragment_begin:Vy,lights_fragment_maps:Hy,lights_fragment_end:Wy,lightprobes_pars_fragment:Xy,logdepthbuf_fragment:$y,logdepthbuf_pars_fragment:qy,logdepthbuf_pars_vertex:Yy,logdepthbuf_vertex:Zy,map_fragment:Ky,map_pars_fragment:Jy,map_particle_fragment:jy,map_particle_pars_fragment:Qy,metalnessmap_fragment:t_,metalnessmap_pars_fragment:e_,morphinstance_vertex:n_,morphcolor_vertex:i_,morphnormal_vertex:s_,morphtarget_pars_vertex:r_,morphtarget_vertex:o_,normal_fragment_begin:a_,normal_fragment_maps:l_,normal_pars_fragment:c_,normal_pars_vertex:h_,normal_vertex:u_,normalmap_pars_fragment:d_,clearcoat_normal_fragment_begin:f_,clearcoat_normal_fragment_maps:p_,clearcoat_pars_fragment:m_,iridescence_pars_fragment:g_,opaque_fragment:x_,packing:v_,premultiplied_alpha_fragment:y_,project_vertex:__,dithering_fragment:b_,dithering_pars_fragment:w_,roughnessmap_fragment:S_,roughnessmap_pars_fragment:M_,shadowmap_pars_fragment:T_,shadowmap_pars_vertex:E_,shadowmap_vertex:A_,shadowmask_pars_fragment:R_,skinbase_vertex:C_,skinning_pars_vertex:P_,skinning_vertex:I_,skinnormal_vertex:L_,specularmap_fragment:D_,specularmap_pars_fragment:N_,tonemapping_fragment:U_,tonemapping_pars_fragment:O_,transmission_fragment:F_,transmission_pars_fragment:k_,uv_pars_fragment:B_,uv_pars_vertex:z_,uv_vertex:G_,worldpos_vertex:V_,background_vert:H_,background_frag:W_,backgroundCube_vert:X_,backgroundCube_frag:$_,cube_vert:q_,cube_frag:Y_,depth_vert:Z_,depth_frag:K_,distance_vert:J_,distance_frag:j_,equirect_vert:Q_,equirect_frag:tb,linedashed_vert:eb,linedashed_frag:nb,meshbasic_vert:ib,meshbasic_frag:sb,meshlambert_vert:rb,meshlambert_frag:ob,meshmatcap_vert:ab,meshmatcap_frag:lb,meshnormal_vert:cb,meshnormal_frag:hb,meshphong_vert:ub,meshphong_frag:db,meshphysical_vert:fb,meshphysical_frag:pb,meshtoon_vert:mb,meshtoon_frag:gb,points_vert:xb,points_frag:vb,shadow_vert:yb,shadow_frag:_b,sprite_vert:bb,sprite_frag:wb},ft={common:{diffuse:{value:new Ct(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Bt},alphaMap:{value:null},alphaMapTransform:{value:new Bt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Bt}},envmap:{envMap:{value:null},envMapRotation:{value:new Bt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Bt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Bt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Bt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Bt},normalScale:{value:new ht(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Bt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Bt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Bt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Bt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ct(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ct(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Bt},alphaTest:{value:0},uvTransform:{value:new Bt}},sprite:{diffuse:{value:new Ct(16777215)},opacity:{value:1},center:{value:new ht(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Bt},alphaMap:{value:null},alphaMapTransform:{value:new Bt},alphaTest:{value:0}}},un={basic:{uniforms:tn([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:qt.meshbasic_vert,fragmentShader:qt.meshbasic_frag},lambert:{uniforms:tn([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ct(0)},envMapIntensity:{value:1}}]),vertexShader:qt.meshlambert_vert,fragmentShader:qt.meshlambert_frag},phong:{uniforms:tn([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ct(0)},specular:{value:new Ct(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:qt.meshphong_vert,fragmentShader:qt.meshphong_frag},standard:{uniforms:tn([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new Ct(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:qt.meshphysical_vert,fragmentShader:qt.meshphysical_frag},toon:{uniforms:tn([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new Ct(0)}}]),vertexShader:qt.meshtoon_vert,fragmentShader:qt.meshtoon_frag},matcap:{uniforms:tn([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:qt.meshmatcap_vert,fragmentShader:qt.meshmatcap_frag},points:{uniforms:tn([ft.points,ft.fog]),vertexShader:qt.points_vert,fragmentShader:qt.points_frag},dashed:{uniforms:tn([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:qt.linedashed_vert,fragmentShader:qt.linedashed_frag},depth:{uniforms:tn([ft.common,ft.displacementmap]),vertexShader:qt.depth_vert,fragmentShader:qt.depth_frag},normal:{uniforms:tn([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:qt.meshnormal_vert,fragmentShader:qt.meshnormal_frag},sprite:{uniforms:tn([ft.sprite,ft.fog]),vertexShader:qt.sprite_vert,fragmentShader:qt.sprite_frag},background:{uniforms:{uvTransform:{value:new Bt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:qt.background_vert,fragmentShader:qt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Bt}},vertexShader:qt.backgroundCube_vert,fragmentShader:qt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:qt.cube_vert,fragmentShader:qt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:qt.equirect_vert,fragmentShader:qt.equirect_frag},distance:{uniforms:tn([ft.common,ft.displacementmap,{referencePosition:{value:new C},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:qt.distance_vert,fragmentShader:qt.distance_frag},shadow:{uniforms:tn([ft.lights,ft.fog,{color:{value:new Ct(0)},opacity:{value:1}}]),vertexShader:qt.shadow_vert,fragmentShader:qt.shadow_frag}};un.physical={uniforms:tn([un.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Bt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Bt},clearcoatNormalScale:{value:new ht(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Bt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Bt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Bt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Bt},sheen:{value:0},sheenColor:{value:new Ct(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Bt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Bt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Bt},transmissionSamplerSize:{value:new ht},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Bt},attenuationDistance:{value:0},attenuationColor:{value:new Ct(0)},specularColor:{value:new Ct(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Bt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Bt},anisotropyVector:{value:new ht},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Bt}}]),vertexShader:qt.meshphysical_vert,fragmentShader:qt.meshphysical_frag};var kc={r:0,b:0,g:0},Sb=new te,zm=new Bt;zm.set(-1,0,0,0,1,0,0,0,1);function Mb(i,t,e,n,s,r){let o=new Ct(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(b){let A=b.isScene===!0?b.background:null;if(A&&A.isTexture){let y=b.backgroundBlurriness>0;A=t.get(A,y)}return A}function p(b){let A=!1,y=f(b);y===null?m(o,a):y&&y.isColor&&(m(y,1),A=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(b,A){let y=f(A);y&&y.isCubeTexture?(c===void 0&&(c=new re(new Vi(1,1,1),new On({name:"BackgroundCubeMaterial",uniforms:bs(un.backgroundCube.uniforms),vertexShader:un.backgroundCube.vertexShader,fragmentShader:un.backgroundCube.fragmentShader,side:hn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,M,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Sb.makeRotationFromEuler(A.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(zm),c.material.toneMapped=jt.getTransfer(y.colorSpace)!==ae,(h!==y||u!==y.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=y,u=y.version,d=i.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new re(new ms(2,2),new On({name:"BackgroundMaterial",uniforms:bs(un.background.uniforms),vertexShader:un.background.vertexShader,fragmentShader:un.background.fragmentShader,side:Zi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=jt.getTransfer(y.colorSpace)!==ae,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(h!==y||u!==y.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=y,u=y.version,d=i.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function m(b,A){b.getRGB(kc,dd(i)),e.buffers.color.setClear(kc.r,kc.g,kc.b,A,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,A=1){o.set(b),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,m(o,a)},render:p,addToRenderList:x,dispose:g}}function Tb(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(U,F,G,L,H){let $=!1,W=u(U,L,G,F);r!==W&&(r=W,c(r.object)),$=f(U,L,G,H),$&&p(U,L,G,H),H!==null&&t.update(H,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,y(U,F,G,L),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function l(){return i.createVertexArray()}function c(U){return i.bindVertexArray(U)}function h(U){return i.deleteVertexArray(U)}function u(U,F,G,L){let H=L.wireframe===!0,$=n[F.id];$===void 0&&($={},n[F.id]=$);let W=U.isInstancedMesh===!0?U.id:0,et=$[W];et===void 0&&(et={},$[W]=et);let X=et[G.id];X===void 0&&(X={},et[G.id]=X);let Q=X[H];return Q===void 0&&(Q=d(l()),X[H]=Q),Q}function d(U){let F=[],G=[],L=[];for(let H=0;H<e;H++)F[H]=0,G[H]=0,L[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:G,attributeDivisors:L,object:U,attributes:{},index:null}}function f(U,F,G,L){let H=r.attributes,$=F.attributes,W=0,et=G.getAttributes();for(let X in et)if(et[X].location>=0){let tt=H[X],_t=$[X];if(_t===void 0&&(X==="instanceMatrix"&&U.instanceMatrix&&(_t=U.instanceMatrix),X==="instanceColor"&&U.instanceColor&&(_t=U.instanceColor)),tt===void 0||tt.attribute!==_t||_t&&tt.data!==_t.data)return!0;W++}return r.attributesNum!==W||r.index!==L}function p(U,F,G,L){let H={},$=F.attributes,W=0,et=G.getAttributes();for(let X in et)if(et[X].location>=0){let tt=$[X];tt===void 0&&(X==="instanceMatrix"&&U.instanceMatrix&&(tt=U.instanceMatrix),X==="instanceColor"&&U.instanceColor&&(tt=U.instanceColor));let _t={};_t.attribute=tt,tt&&tt.data&&(_t.data=tt.data),H[X]=_t,W++}r.attributes=H,r.attributesNum=W,r.index=L}function x(){let U=r.newAttributes;for(let F=0,G=U.length;F<G;F++)U[F]=0}function m(U){g(U,0)}function g(U,F){let G=r.newAttributes,L=r.enabledAttributes,H=r.attributeDivisors;G[U]=1,L[U]===0&&(i.enableVertexAttribArray(U),L[U]=1),H[U]!==F&&(i.vertexAttribDivisor(U,F),H[U]=F)}function b(){let U=r.newAttributes,F=r.enabledAttributes;for(let G=0,L=F.length;G<L;G++)F[G]!==U[G]&&(i.disableVertexAttribArray(G),F[G]=0)}function A(U,F,G,L,H,$,W){W===!0?i.vertexAttribIPointer(U,F,G,H,$):i.vertexAttribPointer(U,F,G,L,H,$)}function y(U,F,G,L){x();let H=L.attributes,$=G.getAttributes(),W=F.defaultAttributeValues;for(let et in $){let X=$[et];if(X.location>=0){let Q=H[et];if(Q===void 0&&(et==="instanceMatrix"&&U.instanceMatrix&&(Q=U.instanceMatrix),et==="instanceColor"&&U.instanceColor&&(Q=U.instanceColor)),Q!==void 0){let tt=Q.normalized,_t=Q.itemSize,Ot=t.get(Q);if(Ot===void 0)continue;let Z=Ot.buffer,gt=Ot.type,wt=Ot.bytesPerElement,Lt=gt===i.INT||gt===i.UNSIGNED_INT||Q.gpuType===ec;if(Q.isInterleavedBufferAttribute){let xt=Q.data,Vt=xt.isInterleavedBuffer===!0?xt.stride:xt.itemSize,Ee=Q.offset;if(xt.isInstancedInterleavedBuffer||xt.isInstancedBufferAttribute){for(let Ut=0;Ut<X.locationSize;Ut++)g(X.location+Ut,xt.meshPerAttribute);U.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=xt.meshPerAttribute*xt.count)}else for(let Ut=0;Ut<X.locationSize;Ut++)m(X.location+Ut);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let Ut=0;Ut<X.locationSize;Ut++)A(X.location+Ut,_t/X.locationSize,gt,tt,Vt*wt,(Ee+_t/X.locationSize*Ut)*wt,Lt)}else{if(Q.isInstancedBufferAttribute){for(let xt=0;xt<X.locationSize;xt++)g(X.location+xt,Q.meshPerAttribute);U.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let xt=0;xt<X.locationSize;xt++)m(X.location+xt);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let xt=0;xt<X.locationSize;xt++)A(X.location+xt,_t/X.locationSize,gt,tt,_t*wt,_t/X.locationSize*xt*wt,Lt)}}else if(W!==void 0){let tt=W[et];if(tt!==void 0)switch(tt.length){case 2:i.vertexAttrib2fv(X.location,tt);break;case 3:i.vertexAttrib3fv(X.location,tt);break;case 4:i.vertexAttrib4fv(X.location,tt);break;default:i.vertexAttrib1fv(X.location,tt)}}}}b()}function E(){N();for(let U in n){let F=n[U];for(let G in F){let L=F[G];for(let H in L){let $=L[H];for(let W in $)h($[W].object),delete $[W];delete L[H]}}delete n[U]}}function M(U){if(n[U.id]===void 0)return;let F=n[U.id];for(let G in F){let L=F[G];for(let H in L){let $=L[H];for(let W in $)h($[W].object),delete $[W];delete L[H]}}delete n[U.id]}function v(U){for(let F in n){let G=n[F];for(let L in G){let H=G[L];if(H[U.id]===void 0)continue;let $=H[U.id];for(let W in $)h($[W].object),delete $[W];delete H[U.id]}}}function T(U){for(let F in n){let G=n[F],L=U.isInstancedMesh===!0?U.id:0,H=G[L];if(H!==void 0){for(let $ in H){let W=H[$];for(let et in W)h(W[et].object),delete W[et];delete H[$]}delete G[L],Object.keys(G).length===0&&delete n[F]}}}function N(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:P,dispose:E,releaseStatesOfGeometry:M,releaseStatesOfObject:T,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:m,disableUnusedAttributes:b}}function Eb(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Ab(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==Jn&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let T=v===Kn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==mn&&v!==Zn&&!T&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(It("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&It("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&It("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),E=i.getParameter(i.MAX_SAMPLES),M=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:b,maxVaryings:A,maxFragmentUniforms:y,maxSamples:E,samples:M}}function Rb(i){let t=this,e=null,n=0,s=!1,r=!1,o=new bn,a=new Bt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let b=r?0:n,A=b*4,y=g.clippingState||null;l.value=y,y=h(p,d,A,f);for(let E=0;E!==A;++E)y[E]=e[E];g.clippingState=y,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,b=d.matrixWorldInverse;a.getNormalMatrix(b),(m===null||m.length<g)&&(m=new Float32Array(g));for(let A=0,y=f;A!==x;++A,y+=4)o.copy(u[A]).applyMatrix4(b,a),o.normal.toArray(m,y),m[y+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var ta=class extends wn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new uo(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Vi(5,5,5),r=new On({name:"CubemapFromEquirect",uniforms:bs(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:hn,blending:xs});r.uniforms.tEquirect.value=e;let o=new re(s,r),a=e.minFilter;return e.minFilter===Ti&&(e.minFilter=on),new fr(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},vm=256,Cb=3,Pb=20,Gm=256,Vm=16,Ib=3,Lb=new C,Db=new Ct,zc=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new fr(1,10,null),this._boxMesh=new re(new Vi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=Lb}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(Db));let m=new fr(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=bm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=_m(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(vm,ld(t))}_fromTexture(t,e){t.mapping===ys||t.mapping===xr?this._setSize(t.image.length===0?vm:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=ym(t,!1,!1),n=Math.log2(t)-Cb;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=ym(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===ys||t.mapping===xr?(this._cubemapMaterial===null&&(this._cubemapMaterial=bm()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=_m()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Nb(),this._integrationMaterial=Ub());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Vm);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Ib)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Gm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Ob());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function ym(i,t,e){return new ta(i,{minFilter:Ti,generateMipmaps:t,type:Kn,colorSpace:eo,depthBuffer:e})}function ea(i,t,e){return new On({name:i,uniforms:t,vertexShader:qt.cube_vert,fragmentShader:e,side:hn,blending:xs,depthTest:!1,depthWrite:!1})}function Nb(){return ea("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Gm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Ub(){return ea("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Vm}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Ob(){return ea("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Pb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function _m(){return ea("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function bm(){return ea("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Fb(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===jl||f===Ql)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new ta(p.height);return x.fromEquirectangularTexture(i,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===jl||f===Ql,x=f===ys||f===xr;if(p||x){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new zc(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let b=d.image;return p&&b&&b.height>0||x&&b&&l(b)?(n===null&&(n=new zc(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===jl?d.mapping=ys:f===Ql&&(d.mapping=xr),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function kb(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Kr("WebGLRenderer: "+n+" extension not supported."),s}}}function Bb(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let m in x)t.update(x[m],i.ARRAY_BUFFER)}function u(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let b=x!==null?x.array.length:m.array.length/3-1,A=m.count>=65535?co:lo,y=new A(Math.ceil(b/3)*6,1),E=y.array;if(x!==null){let v=x.array;g=x.version;for(let T=0,N=0;T<b;T+=3){let P=v[T+0],U=v[T+1],F=v[T+2];E[N++]=P,E[N++]=U,E[N++]=U,E[N++]=F,E[N++]=F,E[N++]=P}}else{g=m.version;for(let v=0,T=0;v<b;v+=3){let N=v+0,P=v+1,U=v+2;E[T++]=N,E[T++]=P,E[T++]=P,E[T++]=U,E[T++]=U,E[T++]=N}}y.version=g;let M=r.get(p);M&&t.remove(M),r.set(p,y)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function zb(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function Gb(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:Ft("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function Vb(i,t,e){let n=new WeakMap,s=new le;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let N=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",N)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],A=0;f===!0&&(A=1),p===!0&&(A=2),x===!0&&(A=3);let y=a.attributes.position.count*A,E=1;y>t.maxTextureSize&&(E=Math.ceil(y/t.maxTextureSize),y=t.maxTextureSize);let M=new Float32Array(y*E*4*u),v=new ro(M,y,E,u);v.type=Zn,v.needsUpdate=!0;let T=A*4;for(let P=0;P<u;P++){let U=m[P],F=g[P],G=b[P],L=y*E*4*P;for(let H=0;H<U.count;H++){let $=H*T;f===!0&&(s.fromBufferAttribute(U,H),M[L+$+0]=s.x,M[L+$+1]=s.y,M[L+$+2]=s.z,M[L+$+3]=0),p===!0&&(s.fromBufferAttribute(F,H),M[L+$+4]=s.x,M[L+$+5]=s.y,M[L+$+6]=s.z,M[L+$+7]=0),x===!0&&(s.fromBufferAttribute(G,H),M[L+$+8]=s.x,M[L+$+9]=s.y,M[L+$+10]=s.z,M[L+$+11]=G.itemSize===4?s.w:1)}}d={count:u,texture:v,size:new ht(y,E)},n.set(a,d),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function Hb(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Wb={[Gu]:"LINEAR_TONE_MAPPING",[Vu]:"REINHARD_TONE_MAPPING",[Hu]:"CINEON_TONE_MAPPING",[Wu]:"ACES_FILMIC_TONE_MAPPING",[$u]:"AGX_TONE_MAPPING",[qu]:"NEUTRAL_TONE_MAPPING",[Xu]:"CUSTOM_TONE_MAPPING"};function Xb(i,t,e,n,s,r){let o=new wn(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Ht;h.setAttribute("position",new Nt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Nt([0,2,0,0,2,0],2));let u=new Ol({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new re(h,u),f=new Oo(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,b=null,A=[],y=!1;this.setSize=function(E,M){o.setSize(E,M),a!==null&&a.setSize(E,M),l!==null&&l.setSize(E,M);for(let v=0;v<A.length;v++){let T=A[v];T.setSize&&T.setSize(E,M)}},this.setEffects=function(E){A=E,y=A.length>0&&A[0].isRenderPass===!0;let M=o.width,v=o.height;A.length>0&&a===null&&(a=new wn(M,v,{type:Kn,depthBuffer:!1,stencilBuffer:!1}),l=new wn(M,v,{type:Kn,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(N=>N.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Mi(M,v),r===!0&&(c.format=Ei,c.type=_s)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let N=0;N<A.length;N++){let P=A[N];P.setSize&&P.setSize(M,v),T&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(E,M){if(m||E.toneMapping===ai&&A.length===0)return!1;if(b=M,M!==null){let v=M.width,T=M.height;(o.width!==v||o.height!==T)&&this.setSize(v,T)}return y===!1&&E.setRenderTarget(o),g=E.toneMapping,E.toneMapping=ai,!0},this.hasRenderPass=function(){return y},this.end=function(E,M){E.toneMapping=g,m=!0;let v=o,T=a;for(let N=0;N<A.length;N++){let P=A[N];P.enabled!==!1&&(P.render(E,T,v,M),P.needsSwap!==!1&&(v=T,T=T===a?l:a))}if(p!==E.outputColorSpace||x!==E.toneMapping){p=E.outputColorSpace,x=E.toneMapping,u.defines={},jt.getTransfer(p)===ae&&(u.defines.SRGB_TRANSFER="");let N=Wb[x];N&&(u.defines[N]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,E.setRenderTarget(b),E.render(d,f),b=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Hm=new ln,Wm=new Mi(1,1),Xm=new fo(1),$m=new ro,qm=new Ml,Ym=new uo,wm=[],Sm=[],Mm=new Float32Array(16),Tm=new Float32Array(9),Em=new Float32Array(4);function br(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=wm[s];if(r===void 0&&(r=new Float32Array(s),wm[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Ie(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Le(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Vc(i,t){let e=Sm[t];e===void 0&&(e=new Int32Array(t),Sm[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function $b(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function qb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ie(e,t))return;i.uniform2fv(this.addr,t),Le(e,t)}}function Yb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Ie(e,t))return;i.uniform3fv(this.addr,t),Le(e,t)}}function Zb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ie(e,t))return;i.uniform4fv(this.addr,t),Le(e,t)}}function Kb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Ie(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Le(e,t)}else{if(Ie(e,n))return;Em.set(n),i.uniformMatrix2fv(this.addr,!1,Em),Le(e,n)}}function Jb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Ie(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Le(e,t)}else{if(Ie(e,n))return;Tm.set(n),i.uniformMatrix3fv(this.addr,!1,Tm),Le(e,n)}}function jb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Ie(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Le(e,t)}else{if(Ie(e,n))return;Mm.set(n),i.uniformMatrix4fv(this.addr,!1,Mm),Le(e,n)}}function Qb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function tw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ie(e,t))return;i.uniform2iv(this.addr,t),Le(e,t)}}function ew(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ie(e,t))return;i.uniform3iv(this.addr,t),Le(e,t)}}function nw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ie(e,t))return;i.uniform4iv(this.addr,t),Le(e,t)}}function iw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function sw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ie(e,t))return;i.uniform2uiv(this.addr,t),Le(e,t)}}function rw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ie(e,t))return;i.uniform3uiv(this.addr,t),Le(e,t)}}function ow(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ie(e,t))return;i.uniform4uiv(this.addr,t),Le(e,t)}}function Hc(i){return i.version===0&&(i.compareFunction=sd,i.needsUpdate=!0),i}function aw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Hc(Wm):r=Hm,e.setTexture2D(t||r,s)}function lw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||qm,s)}function cw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Hc(Xm):r=Ym,e.setTextureCube(t||r,s)}function hw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||$m,s)}function uw(i){switch(i){case 5126:return $b;case 35664:return qb;case 35665:return Yb;case 35666:return Zb;case 35674:return Kb;case 35675:return Jb;case 35676:return jb;case 5124:case 35670:return Qb;case 35667:case 35671:return tw;case 35668:case 35672:return ew;case 35669:case 35673:return nw;case 5125:return iw;case 36294:return sw;case 36295:return rw;case 36296:return ow;case 35678:case 36198:case 36298:case 36306:case 35682:return aw;case 35679:case 36299:case 36307:return lw;case 35680:case 36300:case 36308:case 36293:return cw;case 36289:case 36303:case 36311:case 36292:return hw}}function dw(i,t){i.uniform1fv(this.addr,t)}function fw(i,t){let e=br(t,this.size,2);i.uniform2fv(this.addr,e)}function pw(i,t){let e=br(t,this.size,3);i.uniform3fv(this.addr,e)}function mw(i,t){let e=br(t,this.size,4);i.uniform4fv(this.addr,e)}function gw(i,t){let e=br(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function xw(i,t){let e=br(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function vw(i,t){let e=br(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function yw(i,t){i.uniform1iv(this.addr,t)}function _w(i,t){i.uniform2iv(this.addr,t)}function bw(i,t){i.uniform3iv(this.addr,t)}function ww(i,t){i.uniform4iv(this.addr,t)}function Sw(i,t){i.uniform1uiv(this.addr,t)}function Mw(i,t){i.uniform2uiv(this.addr,t)}function Tw(i,t){i.uniform3uiv(this.addr,t)}function Ew(i,t){i.uniform4uiv(this.addr,t)}function Aw(i,t,e){let n=this.cache,s=t.length,r=Vc(e,s);Ie(n,r)||(i.uniform1iv(this.addr,r),Le(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Hc(Wm):o=Hm;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Rw(i,t,e){let n=this.cache,s=t.length,r=Vc(e,s);Ie(n,r)||(i.uniform1iv(this.addr,r),Le(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||qm,r[o])}function Cw(i,t,e){let n=this.cache,s=t.length,r=Vc(e,s);Ie(n,r)||(i.uniform1iv(this.addr,r),Le(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Hc(Xm):o=Ym;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Pw(i,t,e){let n=this.cache,s=t.length,r=Vc(e,s);Ie(n,r)||(i.uniform1iv(this.addr,r),Le(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||$m,r[o])}function Iw(i){switch(i){case 5126:return dw;case 35664:return fw;case 35665:return pw;case 35666:return mw;case 35674:return gw;case 35675:return xw;case 35676:return vw;case 5124:case 35670:return yw;case 35667:case 35671:return _w;case 35668:case 35672:return bw;case 35669:case 35673:return ww;case 5125:return Sw;case 36294:return Mw;case 36295:return Tw;case 36296:return Ew;case 35678:case 36198:case 36298:case 36306:case 35682:return Aw;case 35679:case 36299:case 36307:return Rw;case 35680:case 36300:case 36308:case 36293:return Cw;case 36289:case 36303:case 36311:case 36292:return Pw}}var vd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=uw(e.type)}},yd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Iw(e.type)}},_d=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},gd=/(\w+)(\])?(\[|\.)?/g;function Am(i,t){i.seq.push(t),i.map[t.id]=t}function Lw(i,t,e){let n=i.name,s=n.length;for(gd.lastIndex=0;;){let r=gd.exec(n),o=gd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Am(e,c===void 0?new vd(a,i,t):new yd(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new _d(a),Am(e,u)),e=u}}}var _r=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);Lw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Rm(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var Dw=37297,Nw=0;function Uw(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Cm=new Bt;function Ow(i){jt._getMatrix(Cm,jt.workingColorSpace,i);let t=`mat3( ${Cm.elements.map(e=>e.toFixed(4))} )`;switch(jt.getTransfer(i)){case no:return[t,"LinearTransferOETF"];case ae:return[t,"sRGBTransferOETF"];default:return It("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Pm(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Uw(i.getShaderSource(t),a)}else return r}function Fw(i,t){let e=Ow(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var kw={[Gu]:"Linear",[Vu]:"Reinhard",[Hu]:"Cineon",[Wu]:"ACESFilmic",[$u]:"AgX",[qu]:"Neutral",[Xu]:"Custom"};function Bw(i,t){let e=kw[t];return e===void 0?(It("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Bc=new C;function zw(){jt.getLuminanceCoefficients(Bc);let i=Bc.x.toFixed(4),t=Bc.y.toFixed(4),e=Bc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Gw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Qo).join(`
`)}function Vw(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Hw(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Qo(i){return i!==""}function Im(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Lm(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Ww=/^[ \t]*#include +<([\w\d./]+)>/gm;function bd(i){return i.replace(Ww,Xw)}function Xw(i,t){let e=qt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return bd(e)}var $w=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Dm(i){return i.replace($w,qw)}function qw(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Nm(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var Yw={[gs]:"SHADOWMAP_TYPE_PCF",[mr]:"SHADOWMAP_TYPE_VSM"};function Zw(i){return Yw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Kw={[xr]:"ENVMAP_MODE_REFRACTION"};function Jw(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Kw[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var jw={[Jl]:"ENVMAP_BLENDING_MULTIPLY",[Kp]:"ENVMAP_BLENDING_MIX",[Jp]:"ENVMAP_BLENDING_ADD"};function Qw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":jw[i.combine]||"ENVMAP_BLENDING_NONE"}function tS(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Zw(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Jw(e),u=Qw(e),d=Gw(e),f=Vw(r),p=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Qo).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Qo).join(`
`),m.length>0&&(m+=`
`)):(x=[Nm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Qo).join(`
`),m=[Nm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ai?"#define TONE_MAPPING":"",e.toneMapping!==ai?qt.tonemapping_pars_fragment:"",e.toneMapping!==ai?Bw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",qt.colorspace_pars_fragment,Fw("linearToOutputTexel",e.outputColorSpace),zw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Qo).join(`
`)),o=bd(o),o=Im(o,e),o=Lm(o,e),a=bd(a),a=Im(a,e),a=Lm(a,e),o=Dm(o),a=Dm(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===od?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===od?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let b=g+x+o,A=g+m+a,y=Rm(s,s.VERTEX_SHADER,b),E=Rm(s,s.FRAGMENT_SHADER,A);s.attachShader(p,y),s.attachShader(p,E),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(P){if(i.debug.checkShaderErrors){let U=s.getProgramInfoLog(p)||"",F=s.getShaderInfoLog(y)||"",G=s.getShaderInfoLog(E)||"",L=U.trim(),H=F.trim(),$=G.trim(),W=!0,et=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(W=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,y,E);else{let X=Pm(s,y,"vertex"),Q=Pm(s,E,"fragment");Ft("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+L+`
`+X+`
`+Q)}else L!==""?It("WebGLProgram: Program Info Log:",L):(H===""||$==="")&&(et=!1);et&&(P.diagnostics={runnable:W,programLog:L,vertexShader:{log:H,prefix:x},fragmentShader:{log:$,prefix:m}})}s.deleteShader(y),s.deleteShader(E),v=new _r(s,p),T=Hw(s,p)}let v;this.getUniforms=function(){return v===void 0&&M(this),v};let T;this.getAttributes=function(){return T===void 0&&M(this),T};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(p,Dw)),N},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Nw++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=y,this.fragmentShader=E,this}var eS=0,wd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Sd(t),e.set(t,n)),n}},Sd=class{constructor(t){this.id=eS++,this.code=t,this.usedTimes=0}};function nS(i){return i===Ki||i===Yo||i===Zo}function iS(i,t,e,n,s,r){let o=new oo,a=new wd,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,T,N,P,U,F){let G=P.fog,L=U.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,W=t.get(v.envMap||H,$),et=d[v.type],X=n.precision;v.precision!==null&&(X=n.getMaxPrecision(v.precision),X!==v.precision&&It("WebGLProgram.getParameters:",v.precision,"not supported, using",X,"instead."));let Q=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,tt=Q!==void 0?Q.length:0,_t=0;L.morphAttributes.position!==void 0&&(_t=1),L.morphAttributes.normal!==void 0&&(_t=2),L.morphAttributes.color!==void 0&&(_t=3);let Ot,Z,gt,wt;if(et){let mt=un[et];Ot=mt.vertexShader,Z=mt.fragmentShader}else{Ot=v.vertexShader,Z=v.fragmentShader;let mt=a.getVertexShaderStage(v),he=a.getFragmentShaderStage(v);a.update(v,mt,he),gt=mt.id,wt=he.id}let Lt=i.getRenderTarget(),xt=i.state.buffers.depth.getReversed(),Vt=U.isInstancedMesh===!0,Ee=U.isBatchedMesh===!0,Ut=!!v.map,ce=!!v.matcap,fe=!!W,Zt=fe&&W.isPMREMTexture===!0,ze=!!v.aoMap,Ce=!!v.lightMap,dn=!!v.bumpMap&&v.wireframe===!1,we=!!v.normalMap,Qn=!!v.displacementMap,Ne=!!v.emissiveMap,Rn=!!v.metalnessMap,Cn=!!v.roughnessMap,Pn=v.anisotropy>0,O=v.clearcoat>0,In=v.diffuseRoughness>0,ye=v.dispersion>0,_e=v.retroreflectivity>0,pt=v.iridescence>0,Pe=v.sheen>0,Dt=v.transmission>0,zt=Pn&&!!v.anisotropyMap,R=O&&!!v.clearcoatMap,_=O&&!!v.clearcoatNormalMap,B=O&&!!v.clearcoatRoughnessMap,nt=In&&!!v.diffuseRoughnessMap,j=pt&&!!v.iridescenceMap,rt=pt&&!!v.iridescenceThicknessMap,ut=Pe&&!!v.sheenColorMap,Y=Pe&&!!v.sheenRoughnessMap,K=!!v.specularMap,at=!!v.specularColorMap,I=!!v.specularIntensityMap,J=Dt&&!!v.transmissionMap,q=Dt&&!!v.thicknessMap,lt=!!v.gradientMap,st=!!v.alphaMap,ot=v.alphaTest>0,At=!!v.alphaHash,Xt=!!v.extensions,it=ai;v.toneMapped&&(Lt===null||Lt.isXRRenderTarget===!0)&&(it=i.toneMapping);let Pt=Zt?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,Wt={shaderID:et,shaderType:v.type,shaderName:v.name,vertexShader:Ot,fragmentShader:Z,defines:v.defines,customVertexShaderID:gt,customFragmentShaderID:wt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:X,batching:Ee,batchingColor:Ee&&U._colorsTexture!==null,instancing:Vt,instancingColor:Vt&&U.instanceColor!==null,instancingMorph:Vt&&U.morphTexture!==null,outputColorSpace:Lt===null?i.outputColorSpace:Lt.isXRRenderTarget===!0?Lt.texture.colorSpace:jt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ut,matcap:ce,envMap:fe,envMapMode:fe&&W.mapping,envMapPMREM:Zt,envMapMaxLod:Zt?Pt.length-1:null,envMapSize:Zt?Pt[0].width:null,aoMap:ze,lightMap:Ce,bumpMap:dn,normalMap:we,displacementMap:Qn,emissiveMap:Ne,normalMapObjectSpace:we&&v.normalMapType===tm,normalMapTangentSpace:we&&v.normalMapType===Ko,packedNormalMap:we&&v.normalMapType===Ko&&nS(v.normalMap.format),metalnessMap:Rn,roughnessMap:Cn,anisotropy:Pn,anisotropyMap:zt,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:_,clearcoatRoughnessMap:B,diffuseRoughness:In,diffuseRoughnessMap:nt,dispersion:ye,retroreflection:_e,iridescence:pt,iridescenceMap:j,iridescenceThicknessMap:rt,sheen:Pe,sheenColorMap:ut,sheenRoughnessMap:Y,specularMap:K,specularColorMap:at,specularIntensityMap:I,transmission:Dt,transmissionMap:J,thicknessMap:q,gradientMap:lt,opaque:v.transparent===!1&&v.blending===gr&&v.alphaToCoverage===!1,alphaMap:st,alphaTest:ot,alphaHash:At,combine:v.combine,mapUv:Ut&&f(v.map.channel),aoMapUv:ze&&f(v.aoMap.channel),lightMapUv:Ce&&f(v.lightMap.channel),bumpMapUv:dn&&f(v.bumpMap.channel),normalMapUv:we&&f(v.normalMap.channel),displacementMapUv:Qn&&f(v.displacementMap.channel),emissiveMapUv:Ne&&f(v.emissiveMap.channel),metalnessMapUv:Rn&&f(v.metalnessMap.channel),roughnessMapUv:Cn&&f(v.roughnessMap.channel),anisotropyMapUv:zt&&f(v.anisotropyMap.channel),clearcoatMapUv:R&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:_&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:nt&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:j&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:rt&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:ut&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:Y&&f(v.sheenRoughnessMap.channel),specularMapUv:K&&f(v.specularMap.channel),specularColorMapUv:at&&f(v.specularColorMap.channel),specularIntensityMapUv:I&&f(v.specularIntensityMap.channel),transmissionMapUv:J&&f(v.transmissionMap.channel),thicknessMapUv:q&&f(v.thicknessMap.channel),alphaMapUv:st&&f(v.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(we||Pn),vertexNormals:!!L.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:U.isPoints===!0&&!!L.attributes.uv&&(Ut||st),fog:!!G,useFog:v.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||L.attributes.normal===void 0&&we===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:xt,skinning:U.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:_t,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:F.filter(mt=>mt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:it,decodeVideoTexture:Ut&&v.map.isVideoTexture===!0&&jt.getTransfer(v.map.colorSpace)===ae,decodeVideoTextureEmissive:Ne&&v.emissiveMap.isVideoTexture===!0&&jt.getTransfer(v.emissiveMap.colorSpace)===ae,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===pn,flipSided:v.side===hn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Xt&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Xt&&v.extensions.multiDraw===!0||Ee)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Wt.vertexUv1s=l.has(1),Wt.vertexUv2s=l.has(2),Wt.vertexUv3s=l.has(3),l.clear(),Wt}function x(v){let T=[];if(v.shaderID?T.push(v.shaderID):(T.push(v.customVertexShaderID),T.push(v.customFragmentShaderID)),v.defines!==void 0)for(let N in v.defines)T.push(N),T.push(v.defines[N]);return v.isRawShaderMaterial===!1&&(m(T,v),g(T,v),T.push(i.outputColorSpace)),T.push(v.customProgramCacheKey),T.join()}function m(v,T){v.push(T.precision),v.push(T.outputColorSpace),v.push(T.envMapMode),v.push(T.envMapPMREM),v.push(T.envMapMaxLod),v.push(T.envMapSize),v.push(T.mapUv),v.push(T.alphaMapUv),v.push(T.lightMapUv),v.push(T.aoMapUv),v.push(T.bumpMapUv),v.push(T.normalMapUv),v.push(T.displacementMapUv),v.push(T.emissiveMapUv),v.push(T.metalnessMapUv),v.push(T.roughnessMapUv),v.push(T.anisotropyMapUv),v.push(T.clearcoatMapUv),v.push(T.clearcoatNormalMapUv),v.push(T.clearcoatRoughnessMapUv),v.push(T.diffuseRoughnessMapUv),v.push(T.iridescenceMapUv),v.push(T.iridescenceThicknessMapUv),v.push(T.sheenColorMapUv),v.push(T.sheenRoughnessMapUv),v.push(T.specularMapUv),v.push(T.specularColorMapUv),v.push(T.specularIntensityMapUv),v.push(T.transmissionMapUv),v.push(T.thicknessMapUv),v.push(T.combine),v.push(T.fogExp2),v.push(T.sizeAttenuation),v.push(T.morphTargetsCount),v.push(T.numSunLights),v.push(T.numDirLights),v.push(T.numPointLights),v.push(T.numSpotLights),v.push(T.numSpotLightMaps),v.push(T.numHemiLights),v.push(T.numRectAreaLights),v.push(T.numSunLightShadows),v.push(T.numDirLightShadows),v.push(T.numPointLightShadows),v.push(T.numSpotLightShadows),v.push(T.numSpotLightShadowsWithMaps),v.push(T.numLightProbes),v.push(T.numLightProbeGrids),v.push(T.shadowMapType),v.push(T.toneMapping),v.push(T.numClippingPlanes),v.push(T.numClipIntersection),v.push(T.depthPacking)}function g(v,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function b(v){let T=d[v.type],N;if(T){let P=un[T];N=Jo.clone(P.uniforms)}else N=v.uniforms;return N}function A(v,T){let N=h.get(T);return N!==void 0?++N.usedTimes:(N=new tS(i,T,v,s),c.push(N),h.set(T,N)),N}function y(v){if(--v.usedTimes===0){let T=c.indexOf(v);c[T]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function E(v){a.remove(v)}function M(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:b,acquireProgram:A,releaseProgram:y,releaseShaderCache:E,programs:c,dispose:M}}function sS(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function rS(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Um(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Om(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let b=i[t];return b===void 0?(b={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},i[t]=b):(b.id=d.id,b.object=d,b.geometry=f,b.material=p,b.materialVariant=o(d),b.groupOrder=x,b.renderOrder=d.renderOrder,b.z=m,b.group=g),t++,b}function l(d,f,p,x,m,g,b){b.reversedDepth===!0&&(m=-m);let A=a(d,f,p,x,m,g);p.transmission>0?n.push(A):p.transparent===!0?s.push(A):e.push(A)}function c(d,f,p,x,m,g){let b=a(d,f,p,x,m,g);p.transmission>0?n.unshift(b):p.transparent===!0?s.unshift(b):e.unshift(b)}function h(d,f){e.length>1&&e.sort(d||rS),n.length>1&&n.sort(f||Um),s.length>1&&s.sort(f||Um)}function u(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function oS(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new Om,i.set(n,[o])):s>=r.length?(o=new Om,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function aS(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new C,color:new Ct};break;case"SpotLight":e={position:new C,direction:new C,color:new Ct,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new C,color:new Ct,distance:0,decay:0};break;case"HemisphereLight":e={direction:new C,skyColor:new Ct,groundColor:new Ct};break;case"RectAreaLight":e={color:new Ct,position:new C,halfWidth:new C,halfHeight:new C};break}return i[t.id]=e,e}}}function lS(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ht};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ht};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ht,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var cS=0;function hS(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function uS(i){let t=new aS,e=lS(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new C);let s=new C,r=new te,o=new te;function a(c){let h=0,u=0,d=0;for(let F=0;F<9;F++)n.probe[F].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,b=0,A=0,y=0,E=0,M=0,v=0,T=0,N=0,P=0;c.sort(hS);for(let F=0,G=c.length;F<G;F++){let L=c[F],H=L.color,$=L.intensity,W=L.distance,et=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===Ki?et=L.shadow.map.texture:et=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)h+=H.r*$,u+=H.g*$,d+=H.b*$;else if(L.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(L.sh.coefficients[X],$);P++}else if(L.isSunLight){let X=t.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Q=L.shadow,tt=e.get(L);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[p]=tt,n.sunShadowMap[p]=et;let _t=Q.getViewportCount();for(let Ot=0;Ot<_t;Ot++)n.sunShadowMatrix[x+Ot]=Q.getMatrix(Ot),n.sunShadowCascade[x+Ot]=Q._cascadeData[Ot];x+=_t,p++}n.sun[f]=X,f++}else if(L.isDirectionalLight){let X=t.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Q=L.shadow,tt=e.get(L);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,n.directionalShadow[m]=tt,n.directionalShadowMap[m]=et,n.directionalShadowMatrix[m]=L.shadow.matrix,E++}n.directional[m]=X,m++}else if(L.isSpotLight){let X=t.get(L);X.position.setFromMatrixPosition(L.matrixWorld),X.color.copy(H).multiplyScalar($),X.distance=W,X.coneCos=Math.cos(L.angle),X.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),X.decay=L.decay,n.spot[b]=X;let Q=L.shadow;if(L.map&&(n.spotLightMap[T]=L.map,T++,Q.updateMatrices(L),L.castShadow&&N++),n.spotLightMatrix[b]=Q.matrix,L.castShadow){let tt=e.get(L);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,n.spotShadow[b]=tt,n.spotShadowMap[b]=et,v++}b++}else if(L.isRectAreaLight){let X=t.get(L);X.color.copy(H).multiplyScalar($),X.halfWidth.set(L.width*.5,0,0),X.halfHeight.set(0,L.height*.5,0),n.rectArea[A]=X,A++}else if(L.isPointLight){let X=t.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),X.distance=L.distance,X.decay=L.decay,L.castShadow){let Q=L.shadow,tt=e.get(L);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,tt.shadowCameraNear=Q.camera.near,tt.shadowCameraFar=Q.camera.far,n.pointShadow[g]=tt,n.pointShadowMap[g]=et,n.pointShadowMatrix[g]=L.shadow.matrix,M++}n.point[g]=X,g++}else if(L.isHemisphereLight){let X=t.get(L);X.skyColor.copy(L.color).multiplyScalar($),X.groundColor.copy(L.groundColor).multiplyScalar($),n.hemi[y]=X,y++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let U=n.hash;(U.sunLength!==f||U.directionalLength!==m||U.pointLength!==g||U.spotLength!==b||U.rectAreaLength!==A||U.hemiLength!==y||U.numSunShadows!==p||U.numDirectionalShadows!==E||U.numPointShadows!==M||U.numSpotShadows!==v||U.numSpotMaps!==T||U.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=m,n.spot.length=b,n.rectArea.length=A,n.point.length=g,n.hemi.length=y,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.directionalShadowMatrix.length=E,n.pointShadow.length=M,n.pointShadowMap.length=M,n.pointShadowMatrix.length=M,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+T-N,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=P,U.sunLength=f,U.directionalLength=m,U.pointLength=g,U.spotLength=b,U.rectAreaLength=A,U.hemiLength=y,U.numSunShadows=p,U.numDirectionalShadows=E,U.numPointShadows=M,U.numSpotShadows=v,U.numSpotMaps=T,U.numLightProbes=P,n.version=cS++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,m=0,g=h.matrixWorldInverse;for(let b=0,A=c.length;b<A;b++){let y=c[b];if(y.isSunLight){let E=n.sun[u];E.direction.setFromMatrixPosition(y.matrixWorld),E.direction.transformDirection(g),u++}else if(y.isDirectionalLight){let E=n.directional[d];E.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),d++}else if(y.isSpotLight){let E=n.spot[p];E.position.setFromMatrixPosition(y.matrixWorld),E.position.applyMatrix4(g),E.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),p++}else if(y.isRectAreaLight){let E=n.rectArea[x];E.position.setFromMatrixPosition(y.matrixWorld),E.position.applyMatrix4(g),o.identity(),r.copy(y.matrixWorld),r.premultiply(g),o.extractRotation(r),E.halfWidth.set(y.width*.5,0,0),E.halfHeight.set(0,y.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),x++}else if(y.isPointLight){let E=n.point[f];E.position.setFromMatrixPosition(y.matrixWorld),E.position.applyMatrix4(g),f++}else if(y.isHemisphereLight){let E=n.hemi[m];E.direction.setFromMatrixPosition(y.matrixWorld),E.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function Fm(i){let t=new uS(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function dS(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Fm(i),t.set(s,[a])):r>=o.length?(a=new Fm(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var fS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,pS=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,mS=[new C(1,0,0),new C(-1,0,0),new C(0,1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1)],gS=[new C(0,-1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1),new C(0,-1,0),new C(0,-1,0)],km=new te,jo=new C,xd=new C;function xS(i,t,e){let n=new Gi,s=new ht,r=new ht,o=new le,a=new Fl,l=new kl,c={},h=e.maxTextureSize,u={[Zi]:hn,[hn]:Zi,[pn]:pn},d=new On({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ht},radius:{value:4}},vertexShader:fS,fragmentShader:pS}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Ht;p.setAttribute("position",new be(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new re(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=gs;let g=this.type;this.render=function(M,v,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||M.length===0)return;this.type===Ip&&(It("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=gs);let N=i.getRenderTarget(),P=i.getActiveCubeFace(),U=i.getActiveMipmapLevel(),F=i.state;F.setBlending(xs),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let G=g!==this.type;G&&v.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(H=>H.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,H=M.length;L<H;L++){let $=M[L],W=$.shadow;if(W===void 0){It("WebGLShadowMap:",$,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let et=W.getFrameExtents();s.multiply(et),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/et.x),s.x=r.x*et.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/et.y),s.y=r.y*et.y,W.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(W.camera._reversedDepth=X,W.map===null||G===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===mr){if($.isPointLight){It("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new wn(s.x,s.y,{format:Ki,type:Kn,minFilter:on,magFilter:on,generateMipmaps:!1}),W.map.texture.name=$.name+".shadowMap",W.map.depthTexture=new Mi(s.x,s.y,Zn),W.map.depthTexture.name=$.name+".shadowMapDepth",W.map.depthTexture.format=Si,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=ke,W.map.depthTexture.magFilter=ke}else $.isPointLight?(W.map=new ta(s.x),W.map.depthTexture=new fo(s.x,Yn)):(W.map=new wn(s.x,s.y),W.map.depthTexture=new Mi(s.x,s.y,Yn)),W.map.depthTexture.name=$.name+".shadowMap",W.map.depthTexture.format=Si,this.type===gs?(W.map.depthTexture.compareFunction=X?id:nd,W.map.depthTexture.minFilter=on,W.map.depthTexture.magFilter=on):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=ke,W.map.depthTexture.magFilter=ke);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let Q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();$.isPointLight!==!0&&W.updateMatrices($,T);let tt=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:T.layers;for(let _t=0;_t<Q;_t++){let Ot=W.getCamera(_t);if($.isPointLight){let Z=W.camera,gt=W.matrix,wt=$.distance||Z.far;wt!==Z.far&&(Z.far=wt,Z.updateProjectionMatrix()),jo.setFromMatrixPosition($.matrixWorld),Z.position.copy(jo),xd.copy(Z.position),xd.add(mS[_t]),Z.up.copy(gS[_t]),Z.lookAt(xd),Z.updateMatrixWorld(),gt.makeTranslation(-jo.x,-jo.y,-jo.z),km.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),W._frustum.setFromProjectionMatrix(km,Z.coordinateSystem,Z.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)i.setRenderTarget(W.map,_t),i.clear();else{_t===0&&(i.setRenderTarget(W.map),i.clear());let Z=W.getViewport(_t);o.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),F.viewport(o)}n=W.getFrustum(_t),y(v,T,Ot,$,tt,this.type)}W.isPointLightShadow!==!0&&this.type===mr&&b(W,T),W.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(N,P,U)};function b(M,v){let T=t.update(x);d.defines.VSM_SAMPLES!==M.blurSamples&&(d.defines.VSM_SAMPLES=M.blurSamples,f.defines.VSM_SAMPLES=M.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),M.mapPass===null?M.mapPass=new wn(s.x,s.y,{format:Ki,type:Kn}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),d.uniforms.shadow_pass.value=M.map.depthTexture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,i.setRenderTarget(M.mapPass),i.clear(),i.renderBufferDirect(v,null,T,d,x,null),f.uniforms.shadow_pass.value=M.mapPass.texture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,i.setRenderTarget(M.map),i.clear(),i.renderBufferDirect(v,null,T,f,x,null)}function A(M,v,T,N){let P=null,U=T.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(U!==void 0)P=U;else if(P=T.isPointLight===!0?l:a,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let F=P.uuid,G=v.uuid,L=c[F];L===void 0&&(L={},c[F]=L);let H=L[G];H===void 0&&(H=P.clone(),L[G]=H,v.addEventListener("dispose",E)),P=H}if(P.visible=v.visible,P.wireframe=v.wireframe,N===mr?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:u[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,T.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let F=i.properties.get(P);F.light=T}return P}function y(M,v,T,N,P,U){if(M.visible===!1)return;if(M.layers.test(P)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&U===mr)&&(!M.frustumCulled||M.intersectsFrustum(n))){M.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,M.matrixWorld);let L=t.update(M),H=M.material;if(Array.isArray(H)){let $=L.groups;for(let W=0,et=$.length;W<et;W++){let X=$[W],Q=H[X.materialIndex];if(Q&&Q.visible){let tt=A(M,Q,N,U);M.onBeforeShadow(i,M,v,T,L,tt,X),i.renderBufferDirect(T,null,L,tt,M,X),M.onAfterShadow(i,M,v,T,L,tt,X)}}}else if(H.visible){let $=A(M,H,N,U);M.onBeforeShadow(i,M,v,T,L,$,null),i.renderBufferDirect(T,null,L,$,M,null),M.onAfterShadow(i,M,v,T,L,$,null)}}let G=M.children;for(let L=0,H=G.length;L<H;L++)y(G[L],v,T,N,P,U)}function E(M){M.target.removeEventListener("dispose",E);for(let T in c){let N=c[T],P=M.target.uuid;P in N&&(N[P].dispose(),delete N[P])}}}function vS(i,t){function e(){let I=!1,J=new le,q=null,lt=new le(0,0,0,0);return{setMask:function(st){q!==st&&!I&&(i.colorMask(st,st,st,st),q=st)},setLocked:function(st){I=st},setClear:function(st,ot,At,Xt,it){it===!0&&(st*=Xt,ot*=Xt,At*=Xt),J.set(st,ot,At,Xt),lt.equals(J)===!1&&(i.clearColor(st,ot,At,Xt),lt.copy(J))},reset:function(){I=!1,q=null,lt.set(-1,0,0,0)}}}function n(){let I=!1,J=!1,q=null,lt=null,st=null;return{setReversed:function(ot){if(J!==ot){let At=t.get("EXT_clip_control");ot?At.clipControlEXT(At.LOWER_LEFT_EXT,At.ZERO_TO_ONE_EXT):At.clipControlEXT(At.LOWER_LEFT_EXT,At.NEGATIVE_ONE_TO_ONE_EXT),J=ot;let Xt=st;st=null,this.setClear(Xt)}},getReversed:function(){return J},setTest:function(ot){ot?xt(i.DEPTH_TEST):Vt(i.DEPTH_TEST)},setMask:function(ot){q!==ot&&!I&&(i.depthMask(ot),q=ot)},setFunc:function(ot){if(J&&(ot=hm[ot]),lt!==ot){switch(ot){case fl:i.depthFunc(i.NEVER);break;case pl:i.depthFunc(i.ALWAYS);break;case ml:i.depthFunc(i.LESS);break;case er:i.depthFunc(i.LEQUAL);break;case gl:i.depthFunc(i.EQUAL);break;case xl:i.depthFunc(i.GEQUAL);break;case vl:i.depthFunc(i.GREATER);break;case yl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}lt=ot}},setLocked:function(ot){I=ot},setClear:function(ot){st!==ot&&(st=ot,J&&(ot=1-ot),i.clearDepth(ot))},reset:function(){I=!1,q=null,lt=null,st=null,J=!1}}}function s(){let I=!1,J=null,q=null,lt=null,st=null,ot=null,At=null,Xt=null,it=null;return{setTest:function(Pt){I||(Pt?xt(i.STENCIL_TEST):Vt(i.STENCIL_TEST))},setMask:function(Pt){J!==Pt&&!I&&(i.stencilMask(Pt),J=Pt)},setFunc:function(Pt,Wt,mt){(q!==Pt||lt!==Wt||st!==mt)&&(i.stencilFunc(Pt,Wt,mt),q=Pt,lt=Wt,st=mt)},setOp:function(Pt,Wt,mt){(ot!==Pt||At!==Wt||Xt!==mt)&&(i.stencilOp(Pt,Wt,mt),ot=Pt,At=Wt,Xt=mt)},setLocked:function(Pt){I=Pt},setClear:function(Pt){it!==Pt&&(i.clearStencil(Pt),it=Pt)},reset:function(){I=!1,J=null,q=null,lt=null,st=null,ot=null,At=null,Xt=null,it=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,b=null,A=null,y=null,E=null,M=null,v=null,T=new Ct(0,0,0),N=0,P=!1,U=null,F=null,G=null,L=null,H=null,$=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,et=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec(X)[1]),W=et>=1):X.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),W=et>=2);let Q=null,tt={},_t=i.getParameter(i.SCISSOR_BOX),Ot=i.getParameter(i.VIEWPORT),Z=new le().fromArray(_t),gt=new le().fromArray(Ot);function wt(I,J,q,lt){let st=new Uint8Array(4),ot=i.createTexture();i.bindTexture(I,ot),i.texParameteri(I,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(I,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let At=0;At<q;At++)I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY?i.texImage3D(J,0,i.RGBA,1,1,lt,0,i.RGBA,i.UNSIGNED_BYTE,st):i.texImage2D(J+At,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,st);return ot}let Lt={};Lt[i.TEXTURE_2D]=wt(i.TEXTURE_2D,i.TEXTURE_2D,1),Lt[i.TEXTURE_CUBE_MAP]=wt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[i.TEXTURE_2D_ARRAY]=wt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Lt[i.TEXTURE_3D]=wt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xt(i.DEPTH_TEST),o.setFunc(er),dn(!1),we(Uu),xt(i.CULL_FACE),ze(xs);function xt(I){h[I]!==!0&&(i.enable(I),h[I]=!0)}function Vt(I){h[I]!==!1&&(i.disable(I),h[I]=!1)}function Ee(I,J){return d[I]!==J?(i.bindFramebuffer(I,J),d[I]=J,I===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=J),I===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=J),!0):!1}function Ut(I,J){let q=p,lt=!1;if(I){q=f.get(J),q===void 0&&(q=[],f.set(J,q));let st=I.textures;if(q.length!==st.length||q[0]!==i.COLOR_ATTACHMENT0){for(let ot=0,At=st.length;ot<At;ot++)q[ot]=i.COLOR_ATTACHMENT0+ot;q.length=st.length,lt=!0}}else q[0]!==i.BACK&&(q[0]=i.BACK,lt=!0);lt&&i.drawBuffers(q)}function ce(I){return x!==I?(i.useProgram(I),x=I,!0):!1}let fe={[vs]:i.FUNC_ADD,[Dp]:i.FUNC_SUBTRACT,[Np]:i.FUNC_REVERSE_SUBTRACT};fe[Up]=i.MIN,fe[Op]=i.MAX;let Zt={[Fp]:i.ZERO,[kp]:i.ONE,[Bp]:i.SRC_COLOR,[Bu]:i.SRC_ALPHA,[Xp]:i.SRC_ALPHA_SATURATE,[Hp]:i.DST_COLOR,[Gp]:i.DST_ALPHA,[zp]:i.ONE_MINUS_SRC_COLOR,[zu]:i.ONE_MINUS_SRC_ALPHA,[Wp]:i.ONE_MINUS_DST_COLOR,[Vp]:i.ONE_MINUS_DST_ALPHA,[$p]:i.CONSTANT_COLOR,[qp]:i.ONE_MINUS_CONSTANT_COLOR,[Yp]:i.CONSTANT_ALPHA,[Zp]:i.ONE_MINUS_CONSTANT_ALPHA};function ze(I,J,q,lt,st,ot,At,Xt,it,Pt){if(I===xs){m===!0&&(Vt(i.BLEND),m=!1);return}if(m===!1&&(xt(i.BLEND),m=!0),I!==Lp){if(I!==g||Pt!==P){if((b!==vs||E!==vs)&&(i.blendEquation(i.FUNC_ADD),b=vs,E=vs),Pt)switch(I){case gr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ou:i.blendFunc(i.ONE,i.ONE);break;case Fu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ku:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ft("WebGLState: Invalid blending: ",I);break}else switch(I){case gr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ou:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Fu:Ft("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ku:Ft("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ft("WebGLState: Invalid blending: ",I);break}A=null,y=null,M=null,v=null,T.set(0,0,0),N=0,g=I,P=Pt}return}st=st||J,ot=ot||q,At=At||lt,(J!==b||st!==E)&&(i.blendEquationSeparate(fe[J],fe[st]),b=J,E=st),(q!==A||lt!==y||ot!==M||At!==v)&&(i.blendFuncSeparate(Zt[q],Zt[lt],Zt[ot],Zt[At]),A=q,y=lt,M=ot,v=At),(Xt.equals(T)===!1||it!==N)&&(i.blendColor(Xt.r,Xt.g,Xt.b,it),T.copy(Xt),N=it),g=I,P=!1}function Ce(I,J){I.side===pn?Vt(i.CULL_FACE):xt(i.CULL_FACE);let q=I.side===hn;J&&(q=!q),dn(q),I.blending===gr&&I.transparent===!1?ze(xs):ze(I.blending,I.blendEquation,I.blendSrc,I.blendDst,I.blendEquationAlpha,I.blendSrcAlpha,I.blendDstAlpha,I.blendColor,I.blendAlpha,I.premultipliedAlpha),o.setFunc(I.depthFunc),o.setTest(I.depthTest),o.setMask(I.depthWrite),r.setMask(I.colorWrite);let lt=I.stencilWrite;a.setTest(lt),lt&&(a.setMask(I.stencilWriteMask),a.setFunc(I.stencilFunc,I.stencilRef,I.stencilFuncMask),a.setOp(I.stencilFail,I.stencilZFail,I.stencilZPass)),Ne(I.polygonOffset,I.polygonOffsetFactor,I.polygonOffsetUnits),I.alphaToCoverage===!0?xt(i.SAMPLE_ALPHA_TO_COVERAGE):Vt(i.SAMPLE_ALPHA_TO_COVERAGE)}function dn(I){U!==I&&(I?i.frontFace(i.CW):i.frontFace(i.CCW),U=I)}function we(I){I!==Cp?(xt(i.CULL_FACE),I!==F&&(I===Uu?i.cullFace(i.BACK):I===Pp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Vt(i.CULL_FACE),F=I}function Qn(I){I!==G&&(W&&i.lineWidth(I),G=I)}function Ne(I,J,q){I?(xt(i.POLYGON_OFFSET_FILL),(L!==J||H!==q)&&(L=J,H=q,o.getReversed()&&(J=-J,q=-q),i.polygonOffset(J,q))):Vt(i.POLYGON_OFFSET_FILL)}function Rn(I){I?xt(i.SCISSOR_TEST):Vt(i.SCISSOR_TEST)}function Cn(I){I===void 0&&(I=i.TEXTURE0+$-1),Q!==I&&(i.activeTexture(I),Q=I)}function Pn(I,J,q){q===void 0&&(Q===null?q=i.TEXTURE0+$-1:q=Q);let lt=tt[q];lt===void 0&&(lt={type:void 0,texture:void 0},tt[q]=lt),(lt.type!==I||lt.texture!==J)&&(Q!==q&&(i.activeTexture(q),Q=q),i.bindTexture(I,J||Lt[I]),lt.type=I,lt.texture=J)}function O(){let I=tt[Q];I!==void 0&&I.type!==void 0&&(i.bindTexture(I.type,null),I.type=void 0,I.texture=void 0)}function In(){try{i.compressedTexImage2D(...arguments)}catch(I){Ft("WebGLState:",I)}}function ye(){try{i.compressedTexImage3D(...arguments)}catch(I){Ft("WebGLState:",I)}}function _e(){try{i.texSubImage2D(...arguments)}catch(I){Ft("WebGLState:",I)}}function pt(){try{i.texSubImage3D(...arguments)}catch(I){Ft("WebGLState:",I)}}function Pe(){try{i.compressedTexSubImage2D(...arguments)}catch(I){Ft("WebGLState:",I)}}function Dt(){try{i.compressedTexSubImage3D(...arguments)}catch(I){Ft("WebGLState:",I)}}function zt(){try{i.texStorage2D(...arguments)}catch(I){Ft("WebGLState:",I)}}function R(){try{i.texStorage3D(...arguments)}catch(I){Ft("WebGLState:",I)}}function _(){try{i.texImage2D(...arguments)}catch(I){Ft("WebGLState:",I)}}function B(){try{i.texImage3D(...arguments)}catch(I){Ft("WebGLState:",I)}}function nt(I){return u[I]!==void 0?u[I]:i.getParameter(I)}function j(I,J){u[I]!==J&&(i.pixelStorei(I,J),u[I]=J)}function rt(I){Z.equals(I)===!1&&(i.scissor(I.x,I.y,I.z,I.w),Z.copy(I))}function ut(I){gt.equals(I)===!1&&(i.viewport(I.x,I.y,I.z,I.w),gt.copy(I))}function Y(I,J){let q=c.get(J);q===void 0&&(q=new WeakMap,c.set(J,q));let lt=q.get(I);lt===void 0&&(lt=i.getUniformBlockIndex(J,I.name),i.uniformBlockBinding(J,lt,lt),q.set(I,lt))}function K(I,J,q){let st=c.get(J).get(I);l[st]!==q&&(i.bindBufferBase(i.UNIFORM_BUFFER,st,q),l[st]=q)}function at(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,tt={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,b=null,A=null,y=null,E=null,M=null,v=null,T=new Ct(0,0,0),N=0,P=!1,U=null,F=null,G=null,L=null,H=null,Z.set(0,0,i.canvas.width,i.canvas.height),gt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xt,disable:Vt,bindFramebuffer:Ee,drawBuffers:Ut,useProgram:ce,setBlending:ze,setMaterial:Ce,setFlipSided:dn,setCullFace:we,setLineWidth:Qn,setPolygonOffset:Ne,setScissorTest:Rn,activeTexture:Cn,bindTexture:Pn,unbindTexture:O,compressedTexImage2D:In,compressedTexImage3D:ye,texImage2D:_,texImage3D:B,pixelStorei:j,getParameter:nt,updateUBOMapping:Y,uniformBlockBinding:K,texStorage2D:zt,texStorage3D:R,texSubImage2D:_e,texSubImage3D:pt,compressedTexSubImage2D:Pe,compressedTexSubImage3D:Dt,scissor:rt,viewport:ut,reset:at}}function yS(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ht,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,_){return m?new OffscreenCanvas(R,_):io("canvas")}function b(R,_,B){let nt=1,j=zt(R);if((j.width>B||j.height>B)&&(nt=B/Math.max(j.width,j.height)),nt<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let rt=Math.floor(nt*j.width),ut=Math.floor(nt*j.height);d===void 0&&(d=g(rt,ut));let Y=_?g(rt,ut):d;return Y.width=rt,Y.height=ut,Y.getContext("2d").drawImage(R,0,0,rt,ut),It("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+rt+"x"+ut+")."),Y}else return"data"in R&&It("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),R;return R}function A(R){return R.generateMipmaps}function y(R){i.generateMipmap(R)}function E(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(R,_,B,nt,j,rt=!1){if(R!==null){if(i[R]!==void 0)return i[R];It("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ut;nt&&(ut=t.get("EXT_texture_norm16"),ut||It("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=_;if(_===i.RED&&(B===i.FLOAT&&(Y=i.R32F),B===i.HALF_FLOAT&&(Y=i.R16F),B===i.UNSIGNED_BYTE&&(Y=i.R8),B===i.UNSIGNED_SHORT&&ut&&(Y=ut.R16_EXT),B===i.SHORT&&ut&&(Y=ut.R16_SNORM_EXT)),_===i.RED_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.R8UI),B===i.UNSIGNED_SHORT&&(Y=i.R16UI),B===i.UNSIGNED_INT&&(Y=i.R32UI),B===i.BYTE&&(Y=i.R8I),B===i.SHORT&&(Y=i.R16I),B===i.INT&&(Y=i.R32I)),_===i.RG&&(B===i.FLOAT&&(Y=i.RG32F),B===i.HALF_FLOAT&&(Y=i.RG16F),B===i.UNSIGNED_BYTE&&(Y=i.RG8),B===i.UNSIGNED_SHORT&&ut&&(Y=ut.RG16_EXT),B===i.SHORT&&ut&&(Y=ut.RG16_SNORM_EXT)),_===i.RG_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.RG8UI),B===i.UNSIGNED_SHORT&&(Y=i.RG16UI),B===i.UNSIGNED_INT&&(Y=i.RG32UI),B===i.BYTE&&(Y=i.RG8I),B===i.SHORT&&(Y=i.RG16I),B===i.INT&&(Y=i.RG32I)),_===i.RGB_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.RGB8UI),B===i.UNSIGNED_SHORT&&(Y=i.RGB16UI),B===i.UNSIGNED_INT&&(Y=i.RGB32UI),B===i.BYTE&&(Y=i.RGB8I),B===i.SHORT&&(Y=i.RGB16I),B===i.INT&&(Y=i.RGB32I)),_===i.RGBA_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.RGBA8UI),B===i.UNSIGNED_SHORT&&(Y=i.RGBA16UI),B===i.UNSIGNED_INT&&(Y=i.RGBA32UI),B===i.BYTE&&(Y=i.RGBA8I),B===i.SHORT&&(Y=i.RGBA16I),B===i.INT&&(Y=i.RGBA32I)),_===i.RGB&&(B===i.UNSIGNED_SHORT&&ut&&(Y=ut.RGB16_EXT),B===i.SHORT&&ut&&(Y=ut.RGB16_SNORM_EXT),B===i.UNSIGNED_INT_5_9_9_9_REV&&(Y=i.RGB9_E5),B===i.UNSIGNED_INT_10F_11F_11F_REV&&(Y=i.R11F_G11F_B10F)),_===i.RGBA){let K=rt?no:jt.getTransfer(j);B===i.FLOAT&&(Y=i.RGBA32F),B===i.HALF_FLOAT&&(Y=i.RGBA16F),B===i.UNSIGNED_BYTE&&(Y=K===ae?i.SRGB8_ALPHA8:i.RGBA8),B===i.UNSIGNED_SHORT&&ut&&(Y=ut.RGBA16_EXT),B===i.SHORT&&ut&&(Y=ut.RGBA16_SNORM_EXT),B===i.UNSIGNED_SHORT_4_4_4_4&&(Y=i.RGBA4),B===i.UNSIGNED_SHORT_5_5_5_1&&(Y=i.RGB5_A1)}return(Y===i.R16F||Y===i.R32F||Y===i.RG16F||Y===i.RG32F||Y===i.RGBA16F||Y===i.RGBA32F)&&t.get("EXT_color_buffer_float"),Y}function v(R,_){let B;return R?_===null||_===Yn||_===_s?B=i.DEPTH24_STENCIL8:_===Zn?B=i.DEPTH32F_STENCIL8:_===vr&&(B=i.DEPTH24_STENCIL8,It("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):_===null||_===Yn||_===_s?B=i.DEPTH_COMPONENT24:_===Zn?B=i.DEPTH_COMPONENT32F:_===vr&&(B=i.DEPTH_COMPONENT16),B}function T(R,_){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==ke&&R.minFilter!==on?Math.log2(Math.max(_.width,_.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?_.mipmaps.length:1}function N(R){let _=new WeakRef(R);n.get(R).__ref=_,p.add(_),x.register(R,_,_)}function P(R){let _=n.get(R).__ref;_!==void 0&&(p.delete(_),x.unregister(_))}function U(R){G(R.target)}function F(R){L(R.target)}function G(R){R.removeEventListener("dispose",U),P(R),$(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function L(R){R.removeEventListener("dispose",F),P(R),et(R)}function H(){for(let R of p){let _=R.deref();_!==void 0&&(_.isRenderTarget===!0?L(_):G(_))}p.clear(),u.clear()}function $(R){let _=n.get(R);if(_.__webglInit===void 0)return;let B=R.source,nt=f.get(B);if(nt){let j=nt[_.__cacheKey];j.usedTimes--,j.usedTimes===0&&W(R),Object.keys(nt).length===0&&f.delete(B)}n.remove(R)}function W(R){let _=n.get(R);i.deleteTexture(_.__webglTexture);let B=R.source,nt=f.get(B);delete nt[_.__cacheKey],o.memory.textures--}function et(R){let _=n.get(R);_.__depthDisposeCallback&&_.__depthDisposeCallback();let B=R.depthTexture;if(B&&B.renderTarget===R&&G(B),R.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(_.__webglFramebuffer[j]))for(let rt=0;rt<_.__webglFramebuffer[j].length;rt++)i.deleteFramebuffer(_.__webglFramebuffer[j][rt]);else i.deleteFramebuffer(_.__webglFramebuffer[j]);_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer[j])}else{if(Array.isArray(_.__webglFramebuffer))for(let j=0;j<_.__webglFramebuffer.length;j++)i.deleteFramebuffer(_.__webglFramebuffer[j]);else i.deleteFramebuffer(_.__webglFramebuffer);if(_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer),_.__webglMultisampledFramebuffer&&i.deleteFramebuffer(_.__webglMultisampledFramebuffer),_.__webglColorRenderbuffer)for(let j=0;j<_.__webglColorRenderbuffer.length;j++)_.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(_.__webglColorRenderbuffer[j]);_.__webglDepthRenderbuffer&&i.deleteRenderbuffer(_.__webglDepthRenderbuffer)}let nt=R.textures;for(let j=0,rt=nt.length;j<rt;j++){let ut=n.get(nt[j]);ut.__webglTexture&&(i.deleteTexture(ut.__webglTexture),o.memory.textures--),n.remove(nt[j])}n.remove(R)}let X=0;function Q(){X=0}function tt(){return X}function _t(R){X=R}function Ot(){let R=X;return R>=s.maxTextures&&It("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,R}function Z(R){let _=[];return _.push(R.wrapS),_.push(R.wrapT),_.push(R.wrapR||0),_.push(R.magFilter),_.push(R.minFilter),_.push(R.anisotropy),_.push(R.internalFormat),_.push(R.format),_.push(R.type),_.push(R.generateMipmaps),_.push(R.mipmapsAutoUpdate),_.push(R.premultiplyAlpha),_.push(R.flipY),_.push(R.unpackAlignment),_.push(R.colorSpace),_.join()}function gt(R,_){let B=n.get(R);if(R.isVideoTexture&&Pe(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&B.__version!==R.version){let nt=R.image;if(nt===null)It("WebGLRenderer: Texture marked for update but no image data found.");else if(nt.complete===!1)It("WebGLRenderer: Texture marked for update but image is incomplete");else{Ce(B,R,_);return}}else R.isExternalTexture&&(B.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,B.__webglTexture,i.TEXTURE0+_)}function wt(R,_){let B=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&B.__version!==R.version){Ce(B,R,_);return}else R.isExternalTexture&&(B.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,B.__webglTexture,i.TEXTURE0+_)}function Lt(R,_){let B=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&B.__version!==R.version){Ce(B,R,_);return}e.bindTexture(i.TEXTURE_3D,B.__webglTexture,i.TEXTURE0+_)}function xt(R,_){let B=n.get(R);if(R.version>0&&B.__version!==R.version){dn(B,R,_);return}e.bindTexture(i.TEXTURE_CUBE_MAP,B.__webglTexture,i.TEXTURE0+_)}let Vt={[nr]:i.REPEAT,[ni]:i.CLAMP_TO_EDGE,[_l]:i.MIRRORED_REPEAT},Ee={[ke]:i.NEAREST,[jp]:i.NEAREST_MIPMAP_NEAREST,[Ho]:i.NEAREST_MIPMAP_LINEAR,[on]:i.LINEAR,[tc]:i.LINEAR_MIPMAP_NEAREST,[Ti]:i.LINEAR_MIPMAP_LINEAR},Ut={[nm]:i.NEVER,[sd]:i.ALWAYS,[im]:i.LESS,[nd]:i.LEQUAL,[sm]:i.EQUAL,[id]:i.GEQUAL,[rm]:i.GREATER,[om]:i.NOTEQUAL};function ce(R,_){if(_.type===Zn&&t.has("OES_texture_float_linear")===!1&&(_.magFilter===on||_.magFilter===tc||_.magFilter===Ho||_.magFilter===Ti||_.minFilter===on||_.minFilter===tc||_.minFilter===Ho||_.minFilter===Ti)&&It("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Vt[_.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Vt[_.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Vt[_.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,Ee[_.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,Ee[_.minFilter]),_.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Ut[_.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(_.magFilter===ke||_.minFilter!==Ho&&_.minFilter!==Ti||_.type===Zn&&t.has("OES_texture_float_linear")===!1)return;if(_.anisotropy>1||n.get(_).__currentAnisotropy){let B=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(_.anisotropy,s.getMaxAnisotropy())),n.get(_).__currentAnisotropy=_.anisotropy}}}function fe(R,_){let B=!1;R.__webglInit===void 0&&(R.__webglInit=!0,_.addEventListener("dispose",U),N(_));let nt=_.source,j=f.get(nt);j===void 0&&(j={},f.set(nt,j));let rt=Z(_);if(rt!==R.__cacheKey){j[rt]===void 0&&(j[rt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,B=!0),j[rt].usedTimes++;let ut=j[R.__cacheKey];ut!==void 0&&(j[R.__cacheKey].usedTimes--,ut.usedTimes===0&&W(_)),R.__cacheKey=rt,R.__webglTexture=j[rt].texture}return B}function Zt(R,_,B){return Math.floor(Math.floor(R/B)/_)}function ze(R,_,B,nt){let rt=R.updateRanges;if(rt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,_.width,_.height,B,nt,_.data);else{rt.sort((I,J)=>I.start-J.start);let ut=0;for(let I=1;I<rt.length;I++){let J=rt[ut],q=rt[I],lt=J.start+J.count,st=Zt(q.start,_.width,4),ot=Zt(J.start,_.width,4);q.start<=lt+1&&st===ot&&Zt(q.start+q.count-1,_.width,4)===st?J.count=Math.max(J.count,q.start+q.count-J.start):(++ut,rt[ut]=q)}rt.length=ut+1;let Y=e.getParameter(i.UNPACK_ROW_LENGTH),K=e.getParameter(i.UNPACK_SKIP_PIXELS),at=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,_.width);for(let I=0,J=rt.length;I<J;I++){let q=rt[I],lt=Math.floor(q.start/4),st=Math.ceil(q.count/4),ot=lt%_.width,At=Math.floor(lt/_.width),Xt=st,it=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,ot),e.pixelStorei(i.UNPACK_SKIP_ROWS,At),e.texSubImage2D(i.TEXTURE_2D,0,ot,At,Xt,it,B,nt,_.data)}R.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,Y),e.pixelStorei(i.UNPACK_SKIP_PIXELS,K),e.pixelStorei(i.UNPACK_SKIP_ROWS,at)}}function Ce(R,_,B){let nt=i.TEXTURE_2D;(_.isDataArrayTexture||_.isCompressedArrayTexture)&&(nt=i.TEXTURE_2D_ARRAY),_.isData3DTexture&&(nt=i.TEXTURE_3D);let j=fe(R,_),rt=_.source;e.bindTexture(nt,R.__webglTexture,i.TEXTURE0+B);let ut=n.get(rt);if(rt.version!==ut.__version||j===!0){if(e.activeTexture(i.TEXTURE0+B),(typeof ImageBitmap<"u"&&_.image instanceof ImageBitmap)===!1){let it=jt.getPrimaries(jt.workingColorSpace),Pt=_.colorSpace===Ai?null:jt.getPrimaries(_.colorSpace),Wt=_.colorSpace===Ai||it===Pt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Wt)}e.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment);let K=b(_.image,!1,s.maxTextureSize);K=Dt(_,K);let at=r.convert(_.format,_.colorSpace),I=r.convert(_.type),J=M(_.internalFormat,at,I,_.normalized,_.colorSpace,_.isVideoTexture);ce(nt,_);let q,lt=_.mipmaps,st=_.isVideoTexture!==!0,ot=ut.__version===void 0||j===!0,At=rt.dataReady,Xt=T(_,K);if(_.isDepthTexture)J=v(_.format===Ei,_.type),ot&&(st?e.texStorage2D(i.TEXTURE_2D,1,J,K.width,K.height):e.texImage2D(i.TEXTURE_2D,0,J,K.width,K.height,0,at,I,null));else if(_.isDataTexture)if(lt.length>0){st&&ot&&e.texStorage2D(i.TEXTURE_2D,Xt,J,lt[0].width,lt[0].height);for(let it=0,Pt=lt.length;it<Pt;it++)q=lt[it],st?At&&e.texSubImage2D(i.TEXTURE_2D,it,0,0,q.width,q.height,at,I,q.data):e.texImage2D(i.TEXTURE_2D,it,J,q.width,q.height,0,at,I,q.data);_.generateMipmaps=!1}else st?(ot&&e.texStorage2D(i.TEXTURE_2D,Xt,J,K.width,K.height),At&&ze(_,K,at,I)):e.texImage2D(i.TEXTURE_2D,0,J,K.width,K.height,0,at,I,K.data);else if(_.isCompressedTexture)if(_.isCompressedArrayTexture){st&&ot&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Xt,J,lt[0].width,lt[0].height,K.depth);for(let it=0,Pt=lt.length;it<Pt;it++)if(q=lt[it],_.format!==Jn)if(at!==null)if(st){if(At)if(_.layerUpdates.size>0){let Wt=md(q.width,q.height,_.format,_.type);for(let mt of _.layerUpdates){let he=q.data.subarray(mt*Wt/q.data.BYTES_PER_ELEMENT,(mt+1)*Wt/q.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,it,0,0,mt,q.width,q.height,1,at,he)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,it,0,0,0,q.width,q.height,K.depth,at,q.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,it,J,q.width,q.height,K.depth,0,q.data,0,0);else It("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else st?At&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,it,0,0,0,q.width,q.height,K.depth,at,I,q.data):e.texImage3D(i.TEXTURE_2D_ARRAY,it,J,q.width,q.height,K.depth,0,at,I,q.data);_.layerUpdates.size>0&&_.clearLayerUpdates()}else{st&&ot&&e.texStorage2D(i.TEXTURE_2D,Xt,J,lt[0].width,lt[0].height);for(let it=0,Pt=lt.length;it<Pt;it++)q=lt[it],_.format!==Jn?at!==null?st?At&&e.compressedTexSubImage2D(i.TEXTURE_2D,it,0,0,q.width,q.height,at,q.data):e.compressedTexImage2D(i.TEXTURE_2D,it,J,q.width,q.height,0,q.data):It("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):st?At&&e.texSubImage2D(i.TEXTURE_2D,it,0,0,q.width,q.height,at,I,q.data):e.texImage2D(i.TEXTURE_2D,it,J,q.width,q.height,0,at,I,q.data)}else if(_.isDataArrayTexture)if(st){if(ot&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Xt,J,K.width,K.height,K.depth),At)if(_.layerUpdates.size>0){let it=md(K.width,K.height,_.format,_.type);for(let Pt of _.layerUpdates){let Wt=K.data.subarray(Pt*it/K.data.BYTES_PER_ELEMENT,(Pt+1)*it/K.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Pt,K.width,K.height,1,at,I,Wt)}_.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,K.width,K.height,K.depth,at,I,K.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,J,K.width,K.height,K.depth,0,at,I,K.data);else if(_.isData3DTexture)st?(ot&&e.texStorage3D(i.TEXTURE_3D,Xt,J,K.width,K.height,K.depth),At&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,K.width,K.height,K.depth,at,I,K.data)):e.texImage3D(i.TEXTURE_3D,0,J,K.width,K.height,K.depth,0,at,I,K.data);else if(_.isFramebufferTexture){if(ot)if(st)e.texStorage2D(i.TEXTURE_2D,Xt,J,K.width,K.height);else{let it=K.width,Pt=K.height;for(let Wt=0;Wt<Xt;Wt++)e.texImage2D(i.TEXTURE_2D,Wt,J,it,Pt,0,at,I,null),it>>=1,Pt>>=1}}else if(_.isHTMLTexture){if("texElementImage2D"in i){let it=i.canvas;if(it.hasAttribute("layoutsubtree")||it.setAttribute("layoutsubtree","true"),K.parentNode!==it){it.appendChild(K),u.add(_),it.onpaint=Pt=>{let Wt=Pt.changedElements;for(let mt of u)Wt.includes(mt.image)&&(mt.needsUpdate=!0)},it.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,K);else{let Wt=i.RGBA,mt=i.RGBA,he=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Wt,mt,he,K)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(lt.length>0){if(st&&ot){let it=zt(lt[0]);e.texStorage2D(i.TEXTURE_2D,Xt,J,it.width,it.height)}for(let it=0,Pt=lt.length;it<Pt;it++)q=lt[it],st?At&&e.texSubImage2D(i.TEXTURE_2D,it,0,0,at,I,q):e.texImage2D(i.TEXTURE_2D,it,J,at,I,q);_.generateMipmaps=!1}else if(st){if(ot){let it=zt(K);e.texStorage2D(i.TEXTURE_2D,Xt,J,it.width,it.height)}At&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at,I,K)}else e.texImage2D(i.TEXTURE_2D,0,J,at,I,K);A(_)&&_.mipmapsAutoUpdate===!0&&y(nt),ut.__version=rt.version,_.onUpdate&&_.onUpdate(_)}R.__version=_.version}function dn(R,_,B){if(_.image.length!==6)return;let nt=fe(R,_),j=_.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+B);let rt=n.get(j);if(j.version!==rt.__version||nt===!0){e.activeTexture(i.TEXTURE0+B);let ut=jt.getPrimaries(jt.workingColorSpace),Y=_.colorSpace===Ai?null:jt.getPrimaries(_.colorSpace),K=_.colorSpace===Ai||ut===Y?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,K);let at=_.isCompressedTexture||_.image[0].isCompressedTexture,I=_.image[0]&&_.image[0].isDataTexture,J=[];for(let mt=0;mt<6;mt++)!at&&!I?J[mt]=b(_.image[mt],!0,s.maxCubemapSize):J[mt]=I?_.image[mt].image:_.image[mt],J[mt]=Dt(_,J[mt]);let q=J[0],lt=r.convert(_.format,_.colorSpace),st=r.convert(_.type),ot=M(_.internalFormat,lt,st,_.normalized,_.colorSpace),At=_.isVideoTexture!==!0,Xt=rt.__version===void 0||nt===!0,it=j.dataReady,Pt=T(_,q);ce(i.TEXTURE_CUBE_MAP,_);let Wt;if(_.isDepthTexture){if(ot=v(_.format===Ei,_.type),Xt)if(At)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,ot,q.width,q.height);else for(let mt=0;mt<6;mt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,ot,q.width,q.height,0,lt,st,null)}else if(at){At&&Xt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Pt,ot,q.width,q.height);for(let mt=0;mt<6;mt++){Wt=J[mt].mipmaps;for(let he=0;he<Wt.length;he++){let Ue=Wt[he];_.format!==Jn?lt!==null?At?it&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,he,0,0,Ue.width,Ue.height,lt,Ue.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,he,ot,Ue.width,Ue.height,0,Ue.data):It("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):At?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,he,0,0,Ue.width,Ue.height,lt,st,Ue.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,he,ot,Ue.width,Ue.height,0,lt,st,Ue.data)}}}else{if(Wt=_.mipmaps,At&&Xt){Wt.length>0&&Pt++;let mt=zt(J[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Pt,ot,mt.width,mt.height)}for(let mt=0;mt<6;mt++)if(I){At?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,0,0,J[mt].width,J[mt].height,lt,st,J[mt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,ot,J[mt].width,J[mt].height,0,lt,st,J[mt].data);for(let he=0;he<Wt.length;he++){let Li=Wt[he].image[mt].image;At?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,he+1,0,0,Li.width,Li.height,lt,st,Li.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,he+1,ot,Li.width,Li.height,0,lt,st,Li.data)}}else{At?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,0,0,lt,st,J[mt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,ot,lt,st,J[mt]);for(let he=0;he<Wt.length;he++){let Ue=Wt[he];At?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,he+1,0,0,lt,st,Ue.image[mt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+mt,he+1,ot,lt,st,Ue.image[mt])}}}A(_)&&_.mipmapsAutoUpdate===!0&&y(i.TEXTURE_CUBE_MAP),rt.__version=j.version,_.onUpdate&&_.onUpdate(_)}R.__version=_.version}function we(R,_,B,nt,j,rt){let ut=r.convert(B.format,B.colorSpace),Y=r.convert(B.type),K=M(B.internalFormat,ut,Y,B.normalized,B.colorSpace),at=n.get(_),I=n.get(B);if(I.__renderTarget=_,!at.__hasExternalTextures){let J=Math.max(1,_.width>>rt),q=Math.max(1,_.height>>rt);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?e.texImage3D(j,rt,K,J,q,_.depth,0,ut,Y,null):e.texImage2D(j,rt,K,J,q,0,ut,Y,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),pt(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,nt,j,I.__webglTexture,0,_e(_)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,nt,j,I.__webglTexture,rt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Qn(R,_,B){if(i.bindRenderbuffer(i.RENDERBUFFER,R),_.depthBuffer){let nt=_.depthTexture,j=nt&&nt.isDepthTexture?nt.type:null,rt=v(_.stencilBuffer,j),ut=_.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;pt(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,_e(_),rt,_.width,_.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,_e(_),rt,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,rt,_.width,_.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ut,i.RENDERBUFFER,R)}else{let nt=_.textures;for(let j=0;j<nt.length;j++){let rt=nt[j],ut=r.convert(rt.format,rt.colorSpace),Y=r.convert(rt.type),K=M(rt.internalFormat,ut,Y,rt.normalized,rt.colorSpace);pt(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,_e(_),K,_.width,_.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,_e(_),K,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,K,_.width,_.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ne(R,_,B){let nt=_.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(_.depthTexture&&_.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=n.get(_.depthTexture);j.__renderTarget=_;let rt=nt?_.depthTexture.image[0]:_.depthTexture.image;(!j.__webglTexture||rt.width!==_.width||rt.height!==_.height)&&(rt.width=_.width,rt.height=_.height,_.depthTexture.needsUpdate=!0),nt?xt(_.depthTexture,0):gt(_.depthTexture,0);let ut=j.__webglTexture,Y=_e(_),K=nt?i.TEXTURE_CUBE_MAP_POSITIVE_X+B:i.TEXTURE_2D,at=_.depthTexture.format===Ei?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(_.depthTexture.format===Si)pt(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,K,ut,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,at,K,ut,0);else if(_.depthTexture.format===Ei)pt(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,K,ut,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,at,K,ut,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Rn(R){let _=n.get(R),B=R.isWebGLCubeRenderTarget===!0;if(_.__boundDepthTexture!==R.depthTexture){let nt=R.depthTexture;if(_.__depthDisposeCallback&&_.__depthDisposeCallback(),nt){let j=()=>{delete _.__boundDepthTexture,delete _.__depthDisposeCallback,nt.removeEventListener("dispose",j)};nt.addEventListener("dispose",j),_.__depthDisposeCallback=j}_.__boundDepthTexture=nt}if(R.depthTexture&&!_.__autoAllocateDepthBuffer)if(B)for(let nt=0;nt<6;nt++)Ne(_.__webglFramebuffer[nt],R,nt);else R.texture.mipmaps.length>0?Ne(_.__webglFramebuffer[0],R,0):Ne(_.__webglFramebuffer,R,0);else if(B){_.__webglDepthbuffer=[];for(let nt=0;nt<6;nt++)if(e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[nt]),_.__webglDepthbuffer[nt]===void 0)_.__webglDepthbuffer[nt]=i.createRenderbuffer(),Qn(_.__webglDepthbuffer[nt],R,!1);else{let j=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,rt=_.__webglDepthbuffer[nt];i.bindRenderbuffer(i.RENDERBUFFER,rt),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,rt)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer),_.__webglDepthbuffer===void 0)_.__webglDepthbuffer=i.createRenderbuffer(),Qn(_.__webglDepthbuffer,R,!1);else{let j=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,rt=_.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,rt),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,rt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Cn(R,_,B){let nt=n.get(R);_!==void 0&&we(nt.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),B!==void 0&&Rn(R)}function Pn(R){let _=R.texture,B=n.get(R),nt=n.get(_);R.addEventListener("dispose",F),N(R);let j=R.textures,rt=R.isWebGLCubeRenderTarget===!0,ut=j.length>1;if(ut||(nt.__webglTexture===void 0&&(nt.__webglTexture=i.createTexture()),nt.__version=_.version,o.memory.textures++),rt){B.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(_.mipmaps.length>0){B.__webglFramebuffer[Y]=[];for(let K=0;K<_.mipmaps.length;K++)B.__webglFramebuffer[Y][K]=i.createFramebuffer()}else B.__webglFramebuffer[Y]=i.createFramebuffer()}else{if(_.mipmaps.length>0){B.__webglFramebuffer=[];for(let Y=0;Y<_.mipmaps.length;Y++)B.__webglFramebuffer[Y]=i.createFramebuffer()}else B.__webglFramebuffer=i.createFramebuffer();if(ut)for(let Y=0,K=j.length;Y<K;Y++){let at=n.get(j[Y]);at.__webglTexture===void 0&&(at.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&pt(R)===!1){B.__webglMultisampledFramebuffer=i.createFramebuffer(),B.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let Y=0;Y<j.length;Y++){let K=j[Y];B.__webglColorRenderbuffer[Y]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,B.__webglColorRenderbuffer[Y]);let at=r.convert(K.format,K.colorSpace),I=r.convert(K.type),J=M(K.internalFormat,at,I,K.normalized,K.colorSpace,R.isXRRenderTarget===!0),q=_e(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,q,J,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Y,i.RENDERBUFFER,B.__webglColorRenderbuffer[Y])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(B.__webglDepthRenderbuffer=i.createRenderbuffer(),Qn(B.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(rt){e.bindTexture(i.TEXTURE_CUBE_MAP,nt.__webglTexture),ce(i.TEXTURE_CUBE_MAP,_);for(let Y=0;Y<6;Y++)if(_.mipmaps.length>0)for(let K=0;K<_.mipmaps.length;K++)we(B.__webglFramebuffer[Y][K],R,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,K);else we(B.__webglFramebuffer[Y],R,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);A(_)?y(i.TEXTURE_CUBE_MAP):_.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),e.unbindTexture()}else if(ut){for(let Y=0,K=j.length;Y<K;Y++){let at=j[Y],I=n.get(at),J=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(J=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(J,I.__webglTexture),ce(J,at),we(B.__webglFramebuffer,R,at,i.COLOR_ATTACHMENT0+Y,J,0),A(at)&&y(J)}e.unbindTexture()}else{let Y=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(Y=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Y,nt.__webglTexture),ce(Y,_),_.mipmaps.length>0)for(let K=0;K<_.mipmaps.length;K++)we(B.__webglFramebuffer[K],R,_,i.COLOR_ATTACHMENT0,Y,K);else we(B.__webglFramebuffer,R,_,i.COLOR_ATTACHMENT0,Y,0);A(_)?y(Y):_.mipmaps.length>0&&i.texParameteri(Y,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&Rn(R)}function O(R){let _=R.textures;for(let B=0,nt=_.length;B<nt;B++){let j=_[B];if(A(j)&&j.mipmapsAutoUpdate===!0){let rt=E(R),ut=n.get(j).__webglTexture;e.bindTexture(rt,ut),y(rt),e.unbindTexture()}}}let In=[];function ye(R){if(R.samples>0){if(pt(R)===!1){let _=R.textures,B=R.width,nt=R.height,j=i.COLOR_BUFFER_BIT,rt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ut=n.get(R),Y=_.length>1;if(Y)for(let at=0;at<_.length;at++)e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ut.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ut.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ut.__webglFramebuffer);for(let at=0;at<_.length;at++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),Y){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ut.__webglColorRenderbuffer[at]);let I=n.get(_[at]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,I,0)}i.blitFramebuffer(0,0,B,nt,0,0,B,nt,j,i.NEAREST),l===!0&&(In.length=0,In.push(i.COLOR_ATTACHMENT0+at),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&In.push(rt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,In))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Y)for(let at=0;at<_.length;at++){e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,ut.__webglColorRenderbuffer[at]);let I=n.get(_[at]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,I,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ut.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let _=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[_])}}}function _e(R){return Math.min(s.maxSamples,R.samples)}function pt(R){let _=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&_.__useRenderToTexture!==!1}function Pe(R){let _=o.render.frame;h.get(R)!==_&&(h.set(R,_),R.update())}function Dt(R,_){let B=R.colorSpace,nt=R.format,j=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||B!==eo&&B!==Ai&&(jt.getTransfer(B)===ae?(nt!==Jn||j!==mn)&&It("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ft("WebGLTextures: Unsupported texture color space:",B)),_}function zt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=Ot,this.resetTextureUnits=Q,this.getTextureUnits=tt,this.setTextureUnits=_t,this.setTexture2D=gt,this.setTexture2DArray=wt,this.setTexture3D=Lt,this.setTextureCube=xt,this.rebindTextures=Cn,this.setupRenderTarget=Pn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=ye,this.setupDepthRenderbuffer=Rn,this.setupFrameBufferTexture=we,this.useMultisampledRTT=pt,this.dispose=H}function _S(i,t){function e(n,s=Ai){let r,o=jt.getTransfer(s);if(n===mn)return i.UNSIGNED_BYTE;if(n===nc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===ic)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ju)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===ju)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Zu)return i.BYTE;if(n===Ku)return i.SHORT;if(n===vr)return i.UNSIGNED_SHORT;if(n===ec)return i.INT;if(n===Yn)return i.UNSIGNED_INT;if(n===Zn)return i.FLOAT;if(n===Kn)return i.HALF_FLOAT;if(n===Qu)return i.ALPHA;if(n===td)return i.RGB;if(n===Jn)return i.RGBA;if(n===Si)return i.DEPTH_COMPONENT;if(n===Ei)return i.DEPTH_STENCIL;if(n===ed)return i.RED;if(n===sc)return i.RED_INTEGER;if(n===Ki)return i.RG;if(n===rc)return i.RG_INTEGER;if(n===oc)return i.RGBA_INTEGER;if(n===Wo||n===Xo||n===$o||n===qo)if(o===ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Wo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Xo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===$o)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===qo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Wo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Xo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===$o)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===qo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===ac||n===lc||n===cc||n===hc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===ac)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===lc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===cc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===hc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===uc||n===dc||n===fc||n===pc||n===mc||n===Yo||n===gc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===uc||n===dc)return o===ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===fc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===pc)return r.COMPRESSED_R11_EAC;if(n===mc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Yo)return r.COMPRESSED_RG11_EAC;if(n===gc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===xc||n===vc||n===yc||n===_c||n===bc||n===wc||n===Sc||n===Mc||n===Tc||n===Ec||n===Ac||n===Rc||n===Cc||n===Pc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===xc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===vc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===yc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===_c)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===bc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===wc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Sc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Mc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Tc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Ec)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ac)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Rc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Cc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Pc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Ic||n===Lc||n===Dc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Ic)return o===ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Lc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Dc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Nc||n===Uc||n===Zo||n===Oc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Nc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Uc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Zo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Oc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===_s?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var bS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,wS=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Md=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new po(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new On({vertexShader:bS,fragmentShader:wS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new re(new ms(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Td=class extends Xn{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new Md,g={},b=e.getContextAttributes(),A=null,y=null,E=[],M=[],v=new ht,T=null,N=null,P=new rn;P.viewport=new le;let U=new rn;U.viewport=new le;let F=[P,U],G=new Kl,L=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let gt=E[Z];return gt===void 0&&(gt=new ar,E[Z]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(Z){let gt=E[Z];return gt===void 0&&(gt=new ar,E[Z]=gt),gt.getGripSpace()},this.getHand=function(Z){let gt=E[Z];return gt===void 0&&(gt=new ar,E[Z]=gt),gt.getHandSpace()};function $(Z){let gt=M.indexOf(Z.inputSource);if(gt===-1)return;let wt=E[gt];wt!==void 0&&(wt.update(Z.inputSource,Z.frame,c||o),wt.dispatchEvent({type:Z.type,data:Z.inputSource}))}function W(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",et);for(let Z=0;Z<E.length;Z++){let gt=M[Z];gt!==null&&(M[Z]=null,E[Z].disconnect(gt))}L=null,H=null,m.reset();for(let Z in g)delete g[Z];if(t.setRenderTarget(A),f=null,d=null,u=null,s=null,y=null,Ot.stop(),n.isPresenting=!1,t.setPixelRatio(T),t.setSize(v.width,v.height,!1),N!==null){let Z=N.camera;Z.fov=N.fov,Z.zoom=N.zoom,Z.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,n.isPresenting===!0&&It("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){a=Z,n.isPresenting===!0&&It("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",W),s.addEventListener("inputsourceschange",et),b.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let wt=null,Lt=null,xt=null;b.depth&&(xt=b.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,wt=b.stencil?Ei:Si,Lt=b.stencil?_s:Yn);let Vt={colorFormat:e.RGBA8,depthFormat:xt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Vt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),y=new wn(d.textureWidth,d.textureHeight,{format:Jn,type:mn,depthTexture:new Mi(d.textureWidth,d.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,wt),stencilBuffer:b.stencil,colorSpace:t.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let wt={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,wt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),y=new wn(f.framebufferWidth,f.framebufferHeight,{format:Jn,type:mn,colorSpace:t.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Ot.setContext(s),Ot.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function et(Z){for(let gt=0;gt<Z.removed.length;gt++){let wt=Z.removed[gt],Lt=M.indexOf(wt);Lt>=0&&(M[Lt]=null,E[Lt].disconnect(wt))}for(let gt=0;gt<Z.added.length;gt++){let wt=Z.added[gt],Lt=M.indexOf(wt);if(Lt===-1){for(let Vt=0;Vt<E.length;Vt++)if(Vt>=M.length){M.push(wt),Lt=Vt;break}else if(M[Vt]===null){M[Vt]=wt,Lt=Vt;break}if(Lt===-1)break}let xt=E[Lt];xt&&xt.connect(wt)}}function X(Z,gt){gt===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(gt.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let gt=Z.near,wt=Z.far;m.texture!==null&&(m.depthNear>0&&(gt=m.depthNear),m.depthFar>0&&(wt=m.depthFar)),G.near=U.near=P.near=gt,G.far=U.far=P.far=wt,(L!==G.near||H!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),L=G.near,H=G.far),G.layers.mask=Z.layers.mask|6,P.layers.mask=G.layers.mask&-5,U.layers.mask=G.layers.mask&-3;let Lt=Z.parent,xt=G.cameras;X(G,Lt);for(let Vt=0;Vt<xt.length;Vt++)X(xt[Vt],Lt);G.projectionMatrix.copy(P.projectionMatrix),G.projectionMatrixInverse.copy(P.projectionMatrixInverse),N===null&&Z.isPerspectiveCamera&&(N={camera:Z,fov:Z.fov,zoom:Z.zoom}),Q(Z,G,Lt)};function Q(Z,gt,wt){wt===null?Z.matrix.copy(gt.matrixWorld):(Z.matrix.copy(wt.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(gt.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(gt.projectionMatrix),Z.projectionMatrixInverse.copy(gt.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=rr*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Z){l=Z,d!==null&&(d.fixedFoveation=Z),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Z)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(Z){return g[Z]};let tt=null;function _t(Z,gt){if(h=gt.getViewerPose(c||o),p=gt,h!==null){let wt=h.views;f!==null&&(t.setRenderTargetFramebuffer(y,f.framebuffer),t.setRenderTarget(y));let Lt=!1;wt.length!==G.cameras.length&&(G.cameras.length=0,Lt=!0);for(let Ut=0;Ut<wt.length;Ut++){let ce=wt[Ut],fe=null;if(f!==null)fe=f.getViewport(ce);else{let ze=u.getViewSubImage(d,ce);fe=ze.viewport,Ut===0&&(t.setRenderTargetTextures(y,ze.colorTexture,ze.depthStencilTexture),t.setRenderTarget(y))}let Zt=F[Ut];Zt===void 0&&(Zt=new rn,Zt.layers.enable(Ut),Zt.viewport=new le,F[Ut]=Zt),Zt.matrix.fromArray(ce.transform.matrix),Zt.matrix.decompose(Zt.position,Zt.quaternion,Zt.scale),Zt.projectionMatrix.fromArray(ce.projectionMatrix),Zt.projectionMatrixInverse.copy(Zt.projectionMatrix).invert(),Zt.viewport.set(fe.x,fe.y,fe.width,fe.height),Ut===0&&(G.matrix.copy(Zt.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Lt===!0&&G.cameras.push(Zt)}let xt=s.enabledFeatures;if(xt&&xt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Ut=u.getDepthInformation(wt[0]);Ut&&Ut.isValid&&Ut.texture&&m.init(Ut,s.renderState)}if(xt&&xt.includes("camera-access")&&x){t.state.unbindTexture(),u=n.getBinding();for(let Ut=0;Ut<wt.length;Ut++){let ce=wt[Ut].camera;if(ce){let fe=g[ce];fe||(fe=new po,g[ce]=fe);let Zt=u.getCameraImage(ce);fe.sourceTexture=Zt}}}}for(let wt=0;wt<E.length;wt++){let Lt=M[wt],xt=E[wt];Lt!==null&&xt!==void 0&&xt.update(Lt,gt,c||o)}tt&&tt(Z,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),p=null}let Ot=new Bm;Ot.setAnimationLoop(_t),this.setAnimationLoop=function(Z){tt=Z},this.dispose=function(){}}},SS=new te,Zm=new Bt;Zm.set(-1,0,0,0,1,0,0,0,1);function MS(i,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,dd(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,b,A,y){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,y)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,b,A):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===hn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===hn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let b=t.get(g),A=b.envMap,y=b.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(SS.makeRotationFromEuler(y)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Zm),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,b,A){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*b,m.scale.value=A*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,b){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===hn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=b.texture,m.transmissionSamplerSize.value.set(b.width,b.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let b=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(b.matrixWorld),m.nearDistance.value=b.shadow.camera.near,m.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function TS(i,t,e,n){let s={},r={};function o(b,A){let y=A.program;n.uniformBlockBinding(b,y,s[b.id])}function a(b,A){let y=s[b.id];y===void 0&&(p(b),y=l(b),s[b.id]=y,b.addEventListener("dispose",m));let E=A.program;n.updateUBOMapping(b,E);let M=t.render.frame;r[b.id]!==M&&(c(b),r[b.id]=M)}function l(b){let A=i.createBuffer(),y=b.__size,E=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,y,E),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(b){let A=s[b.id],y=b.uniforms,E=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let M=0,v=y.length;M<v;M++){let T=y[M];if(Array.isArray(T))for(let N=0,P=T.length;N<P;N++)h(T[N],M,N,E);else h(T,M,0,E)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(b,A,y,E){if(d(b,A,y,E)===!0){let M=b.__offset,v=b.value;if(Array.isArray(v)){let T=0;for(let N=0;N<v.length;N++){let P=v[N],U=x(P,!0);u(P,b.__data,T),T+=U.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,b.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,M,b.__data)}}function u(b,A,y){typeof b=="number"||typeof b=="boolean"?A[y]=b:b.isMatrix3?(A[y]=b.elements[0],A[y+1]=b.elements[1],A[y+2]=b.elements[2],A[y+3]=0,A[y+4]=b.elements[3],A[y+5]=b.elements[4],A[y+6]=b.elements[5],A[y+7]=0,A[y+8]=b.elements[6],A[y+9]=b.elements[7],A[y+10]=b.elements[8],A[y+11]=0):ArrayBuffer.isView(b)?A.set(b.subarray(0,A.length-y),y):b.toArray(A,y)}function d(b,A,y,E){let M=b.value,v=A+"_"+y;if(Array.isArray(M)){E[v]===void 0&&(E[v]=[]);let T=E[v],N=!1;for(let P=0;P<M.length;P++)f(M[P],T,P)===!0&&(N=!0);return N}return f(M,E,v)}function f(b,A,y){if(A[y]===void 0)return typeof b=="number"||typeof b=="boolean"?A[y]=b:ArrayBuffer.isView(b)?A[y]=b.slice():A[y]=b.clone(),!0;{let E=A[y];if(typeof b=="number"||typeof b=="boolean"){if(E!==b)return A[y]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(E.equals(b)===!1)return E.copy(b),!0}}return!1}function p(b){let A=b.uniforms,y=0,E=16;for(let v=0,T=A.length;v<T;v++){let N=Array.isArray(A[v])?A[v]:[A[v]];for(let P=0,U=N.length;P<U;P++){let F=N[P],G=Array.isArray(F.value)?F.value:[F.value],L=Array.isArray(A[v])||Array.isArray(F.value),H=y;for(let W=0,et=G.length;W<et;W++){let X=G[W],Q=x(X,L),tt=y%E,_t=tt%Q.boundary,Ot=tt+_t;y+=_t,Ot!==0&&E-Ot<Q.storage&&(y+=E-Ot),W===0&&(H=y),y+=Q.storage}let $=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new $((y-H)/Float32Array.BYTES_PER_ELEMENT),F.__offset=H}}let M=y%E;return M>0&&(y+=E-M),b.__size=y,b.__cache={},this}function x(b,A){let y={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(y.boundary=4,y.storage=4):b.isVector2?(y.boundary=8,y.storage=8):b.isVector3||b.isColor?(y.boundary=16,y.storage=12):b.isVector4?(y.boundary=16,y.storage=16):b.isMatrix3?(y.boundary=16,y.storage=48):b.isMatrix4?(y.boundary=16,y.storage=64):b.isTexture?It("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(y.boundary=16,y.storage=b.byteLength):It("WebGLRenderer: Unsupported uniform value type.",b),A===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function m(b){let A=b.target;A.removeEventListener("dispose",m),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function g(){for(let b in s)i.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:g}}var ES=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),li=null;function AS(){return li===null&&(li=new Tl(ES,16,16,Ki,Kn),li.name="DFG_LUT",li.minFilter=on,li.magFilter=on,li.wrapS=ni,li.wrapT=ni,li.generateMipmaps=!1,li.needsUpdate=!0),li}var Gc=class{constructor(t={}){let{canvas:e=am(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=mn}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,m=new Set([oc,rc,sc]),g=new Set([mn,Yn,vr,_s,nc,ic]),b=new Uint32Array(4),A=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},E=null,M=null,v=[],T=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ai,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,U=!1,F=null,G=null,L=null,H=null;this._outputColorSpace=He;let $=0,W=0,et=null,X=-1,Q=null,tt=new le,_t=new le,Ot=null,Z=new Ct(0),gt=0,wt=e.width,Lt=e.height,xt=1,Vt=null,Ee=null,Ut=new le(0,0,wt,Lt),ce=new le(0,0,wt,Lt),fe=!1,Zt=new Gi,ze=new El,Ce=!1,dn=!1,we=new te,Qn=new C,Ne=new le,Rn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Cn=!1;function Pn(){return et===null?xt:1}let O=n;function In(w,D){return e.getContext(w,D)}let ye,_e,pt,Pe,Dt,zt,R,_,B,nt,j,rt,ut,Y,K,at,I,J,q,lt,st,ot,At;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Pt,!1),e.addEventListener("webglcontextrestored",Wt,!1),e.addEventListener("webglcontextcreationerror",mt,!1),O===null){let D="webgl2";if(O=In(D,w),O===null)throw In(D)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Xt()}catch(w){throw e.removeEventListener("webglcontextlost",Pt,!1),e.removeEventListener("webglcontextrestored",Wt,!1),e.removeEventListener("webglcontextcreationerror",mt,!1),Ft("WebGLRenderer: "+w.message),w}function Xt(){ye=new kb(O),ye.init(),st=new _S(O,ye),_e=new Ab(O,ye,t,st),pt=new vS(O,ye),_e.reversedDepthBuffer&&d&&pt.buffers.depth.setReversed(!0),G=O.createFramebuffer(),L=O.createFramebuffer(),H=O.createFramebuffer(),Pe=new Gb(O),Dt=new sS,zt=new yS(O,ye,pt,Dt,_e,st,Pe),R=new Fb(P),_=new Hv(O),ot=new Tb(O,_),B=new Bb(O,_,Pe,ot),nt=new Hb(O,B,_,ot,Pe),J=new Vb(O,_e,zt),K=new Rb(Dt),j=new iS(P,R,ye,_e,ot,K),rt=new MS(P,Dt),ut=new oS,Y=new dS(ye),I=new Mb(P,R,pt,nt,p,l),at=new xS(P,nt,_e),At=new TS(O,Pe,_e,pt),q=new Eb(O,ye,Pe),lt=new zb(O,ye,Pe),Pe.programs=j.programs,P.capabilities=_e,P.extensions=ye,P.properties=Dt,P.renderLists=ut,P.shadowMap=at,P.state=pt,P.info=Pe}x!==mn&&(N=new Xb(x,e.width,e.height,a,s,r));let it=new Td(P,O);this.xr=it,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let w=ye.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=ye.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return xt},this.setPixelRatio=function(w){w!==void 0&&(xt=w,this.setSize(wt,Lt,!1))},this.getSize=function(w){return w.set(wt,Lt)},this.setSize=function(w,D,V=!0){if(it.isPresenting){It("WebGLRenderer: Can't change size while VR device is presenting.");return}wt=w,Lt=D,e.width=Math.floor(w*xt),e.height=Math.floor(D*xt),V===!0&&(e.style.width=w+"px",e.style.height=D+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,w,D)},this.getDrawingBufferSize=function(w){return w.set(wt*xt,Lt*xt).floor()},this.setDrawingBufferSize=function(w,D,V){wt=w,Lt=D,xt=V,e.width=Math.floor(w*V),e.height=Math.floor(D*V),this.setViewport(0,0,w,D)},this.setEffects=function(w){if(x===mn){Ft("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let D=0;D<w.length;D++)if(w[D].isOutputPass===!0){It("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(tt)},this.getViewport=function(w){return w.copy(Ut)},this.setViewport=function(w,D,V,k){w.isVector4?Ut.set(w.x,w.y,w.z,w.w):Ut.set(w,D,V,k),pt.viewport(tt.copy(Ut).multiplyScalar(Pn()).round())},this.getScissor=function(w){return w.copy(ce)},this.setScissor=function(w,D,V,k){w.isVector4?ce.set(w.x,w.y,w.z,w.w):ce.set(w,D,V,k),pt.scissor(_t.copy(ce).multiplyScalar(Pn()).round())},this.getScissorTest=function(){return fe},this.setScissorTest=function(w){pt.setScissorTest(fe=w)},this.setOpaqueSort=function(w){Vt=w},this.setTransparentSort=function(w){Ee=w},this.getClearColor=function(w){return w.copy(I.getClearColor())},this.setClearColor=function(){I.setClearColor(...arguments)},this.getClearAlpha=function(){return I.getClearAlpha()},this.setClearAlpha=function(){I.setClearAlpha(...arguments)},this.clear=function(w=!0,D=!0,V=!0){let k=0;if(w){let z=!1;if(et!==null){let dt=et.texture.format;z=m.has(dt)}if(z){let dt=et.texture.type,bt=g.has(dt),ct=I.getClearColor(),vt=I.getClearAlpha(),Tt=ct.r,Gt=ct.g,Kt=ct.b;bt?(b[0]=Tt,b[1]=Gt,b[2]=Kt,b[3]=vt,O.clearBufferuiv(O.COLOR,0,b)):(A[0]=Tt,A[1]=Gt,A[2]=Kt,A[3]=vt,O.clearBufferiv(O.COLOR,0,A))}else k|=O.COLOR_BUFFER_BIT}D&&(k|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),V&&(k|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&O.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),F=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Pt,!1),e.removeEventListener("webglcontextrestored",Wt,!1),e.removeEventListener("webglcontextcreationerror",mt,!1),I.dispose(),ut.dispose(),Y.dispose(),zt.dispose(),Dt.dispose(),R.dispose(),nt.dispose(),B.dispose(),ot.dispose(),At.dispose(),j.dispose(),it.dispose(),it.removeEventListener("sessionstart",Sf),it.removeEventListener("sessionend",Mf),ss.stop()};function Pt(w){w.preventDefault(),so("WebGLRenderer: Context Lost."),U=!0}function Wt(){so("WebGLRenderer: Context Restored."),U=!1;let w=Pe.autoReset,D=at.enabled,V=at.autoUpdate,k=at.needsUpdate,z=at.type;Xt(),Pe.autoReset=w,at.enabled=D,at.autoUpdate=V,at.needsUpdate=k,at.type=z}function mt(w){Ft("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function he(w){let D=w.target;D.removeEventListener("dispose",he),Ue(D)}function Ue(w){Li(w),Dt.remove(w)}function Li(w){let D=Dt.get(w).programs;D!==void 0&&(D.forEach(function(V){j.releaseProgram(V)}),w.isShaderMaterial&&j.releaseShaderCache(w))}this.renderBufferDirect=function(w,D,V,k,z,dt){D===null&&(D=Rn);let bt=z.isMesh&&z.matrixWorld.determinantAffine()<0,ct=H0(w,D,V,k,z);pt.setMaterial(k,bt);let vt=V.index,Tt=1;if(k.wireframe===!0){if(vt=B.getWireframeAttribute(V),vt===void 0)return;Tt=2}let Gt=V.drawRange,Kt=V.attributes.position,St=Gt.start*Tt,Jt=(Gt.start+Gt.count)*Tt;dt!==null&&(St=Math.max(St,dt.start*Tt),Jt=Math.min(Jt,(dt.start+dt.count)*Tt)),vt!==null?(St=Math.max(St,0),Jt=Math.min(Jt,vt.count)):Kt!=null&&(St=Math.max(St,0),Jt=Math.min(Jt,Kt.count));let Ae=Jt-St;if(Ae<0||Ae===1/0)return;ot.setup(z,k,ct,V,vt);let ge,pe=q;if(vt!==null&&(ge=_.get(vt),pe=lt,pe.setIndex(ge)),z.isMesh)k.wireframe===!0?(pt.setLineWidth(k.wireframeLinewidth*Pn()),pe.setMode(O.LINES)):pe.setMode(O.TRIANGLES);else if(z.isLine){let Ze=k.linewidth;Ze===void 0&&(Ze=1),pt.setLineWidth(Ze*Pn()),z.isLineSegments?pe.setMode(O.LINES):z.isLineLoop?pe.setMode(O.LINE_LOOP):pe.setMode(O.LINE_STRIP)}else z.isPoints?pe.setMode(O.POINTS):z.isSprite&&pe.setMode(O.TRIANGLES);if(z.isBatchedMesh)if(ye.get("WEBGL_multi_draw"))pe.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let Ze=z._multiDrawStarts,Mt=z._multiDrawCounts,nn=z._multiDrawCount,se=vt?_.get(vt).bytesPerElement:1,rs=Dt.get(k).currentProgram.getUniforms();for(let Ke=0;Ke<nn;Ke++)rs.setValue(O,"_gl_DrawID",Ke),pe.render(Ze[Ke]/se,Mt[Ke])}else if(z.isInstancedMesh)pe.renderInstances(St,Ae,z.count);else if(V.isInstancedBufferGeometry){let Ze=V._maxInstanceCount!==void 0?V._maxInstanceCount:1/0,Mt=Math.min(V.instanceCount,Ze);pe.renderInstances(St,Ae,Mt)}else pe.render(St,Ae)};function wf(w,D,V,k){F!==null&&w.isNodeMaterial&&F.setObject(k,w),Ce===!0&&K.setState(w,V,!1),w.transparent===!0&&w.side===pn&&w.forceSinglePass===!1?(w.side=hn,w.needsUpdate=!0,Br(w,D,k),w.side=Zi,w.needsUpdate=!0,Br(w,D,k),w.side=pn):Br(w,D,k)}this.compile=function(w,D,V=null){V===null&&(V=w),F!==null&&F.renderStart(w,D,V),M=Y.get(V),M.init(D),T.push(M),V.traverseVisible(function(z){z.isLight&&z.layers.test(D.layers)&&(M.pushLight(z),z.castShadow&&M.pushShadow(z))}),w!==V&&w.traverseVisible(function(z){z.isLight&&z.layers.test(D.layers)&&(M.pushLight(z),z.castShadow&&M.pushShadow(z))}),M.setupLights(),F!==null&&F.updateLights(M.state.lightsArray),dn=this.localClippingEnabled,Ce=K.init(this.clippingPlanes,dn),Ce===!0&&K.setGlobalState(this.clippingPlanes,D),F!==null&&at.render(M.state.shadowsArray,V,D);let k=new Set;return w.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let dt=z.material;if(dt)if(Array.isArray(dt))for(let bt=0;bt<dt.length;bt++){let ct=dt[bt];wf(ct,V,D,z),k.add(ct)}else wf(dt,V,D,z),k.add(dt)}),M=T.pop(),F!==null&&F.renderEnd(),k},this.compileAsync=function(w,D,V=null){let k=this.compile(w,D,V);return new Promise(z=>{function dt(){if(k.forEach(function(bt){let vt=Dt.get(bt).currentProgram;(vt===void 0||vt.isReady())&&k.delete(bt)}),k.size===0){z(w);return}setTimeout(dt,10)}ye.get("KHR_parallel_shader_compile")!==null?dt():setTimeout(dt,10)})};let Yh=null;function G0(w){Yh&&Yh(w)}function Sf(){ss.stop()}function Mf(){ss.start()}let ss=new Bm;ss.setAnimationLoop(G0),typeof self<"u"&&ss.setContext(self),this.setAnimationLoop=function(w){Yh=w,it.setAnimationLoop(w),w===null?ss.stop():ss.start()},it.addEventListener("sessionstart",Sf),it.addEventListener("sessionend",Mf),this.render=function(w,D){if(D!==void 0&&D.isCamera!==!0){Ft("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;F!==null&&F.renderStart(w,D);let V=it.enabled===!0&&it.isPresenting===!0,k=N!==null&&(et===null||V)&&N.begin(P,et);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),D.parent===null&&D.matrixWorldAutoUpdate===!0&&D.updateMatrixWorld(),it.enabled===!0&&it.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(it.cameraAutoUpdate===!0&&it.updateCamera(D),D=it.getCamera()),w.isScene===!0&&w.onBeforeRender(P,w,D,et),M=Y.get(w,T.length),M.init(D),M.state.textureUnits=zt.getTextureUnits(),T.push(M),we.multiplyMatrices(D.projectionMatrix,D.matrixWorldInverse),D.isArrayCamera?ze.setFromArrayCamera(D):Zt.setFromProjectionMatrix(we,Dn,D.reversedDepth),dn=this.localClippingEnabled,Ce=K.init(this.clippingPlanes,dn),E=ut.get(w,v.length),E.init(),v.push(E),this.info.render.frame++,it.enabled===!0&&it.isPresenting===!0){let bt=P.xr.getDepthSensingMesh();bt!==null&&Zh(bt,D,-1/0,P.sortObjects)}Zh(w,D,0,P.sortObjects),E.finish(),F!==null&&F.updateLights(M.state.lightsArray),P.sortObjects===!0&&E.sort(Vt,Ee),Cn=it.enabled===!1||it.isPresenting===!1||it.hasDepthSensing()===!1,Cn&&I.addToRenderList(E,w),this.info.autoReset===!0&&this.info.reset(),Ce===!0&&K.beginShadows();let z=M.state.shadowsArray;if(at.render(z,w,D),Ce===!0&&K.endShadows(),(k&&N.hasRenderPass())===!1){let bt=E.opaque,ct=E.transmissive;if(M.setupLights(),D.isArrayCamera){let vt=D.cameras;if(ct.length>0)for(let Tt=0,Gt=vt.length;Tt<Gt;Tt++){let Kt=vt[Tt];Ef(bt,ct,w,Kt)}Cn&&I.render(w);for(let Tt=0,Gt=vt.length;Tt<Gt;Tt++){let Kt=vt[Tt];Tf(E,w,Kt,Kt.viewport)}}else ct.length>0&&Ef(bt,ct,w,D),Cn&&I.render(w),Tf(E,w,D)}et!==null&&W===0&&(zt.updateMultisampleRenderTarget(et),zt.updateRenderTargetMipmap(et)),k&&N.end(P),w.isScene===!0&&w.onAfterRender(P,w,D),ot.resetDefaultState(),X=-1,Q=null,T.pop(),T.length>0?(M=T[T.length-1],zt.setTextureUnits(M.state.textureUnits),Ce===!0&&K.setGlobalState(P.clippingPlanes,M.state.camera)):M=null,v.pop(),v.length>0?E=v[v.length-1]:E=null,F!==null&&F.renderEnd()};function Zh(w,D,V,k){if(w.visible===!1)return;if(w.layers.test(D.layers)){if(w.isGroup)V=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(D);else if(w.isLight)M.pushLight(w),w.castShadow&&M.pushShadow(w);else if(w.isSprite){let bt=D.isArrayCamera?ze:Zt;if(!w.frustumCulled||w.intersectsFrustum(bt)){k&&Ne.setFromMatrixPosition(w.matrixWorld).applyMatrix4(we);let ct=nt.update(w),vt=w.material;vt.visible&&E.push(w,ct,vt,V,Ne.z,null,D)}}else if(w.isMesh||w.isLine||w.isPoints){let bt=D.isArrayCamera?ze:Zt;if(!w.frustumCulled||w.intersectsFrustum(bt)){let ct=nt.update(w),vt=w.material;if(k&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),Ne.copy(w.boundingSphere.center)):(ct.boundingSphere===null&&ct.computeBoundingSphere(),Ne.copy(ct.boundingSphere.center)),Ne.applyMatrix4(w.matrixWorld).applyMatrix4(we)),Array.isArray(vt)){let Tt=ct.groups;for(let Gt=0,Kt=Tt.length;Gt<Kt;Gt++){let St=Tt[Gt],Jt=vt[St.materialIndex];Jt&&Jt.visible&&E.push(w,ct,Jt,V,Ne.z,St,D)}}else vt.visible&&E.push(w,ct,vt,V,Ne.z,null,D)}}}let dt=w.children;for(let bt=0,ct=dt.length;bt<ct;bt++)Zh(dt[bt],D,V,k)}function Tf(w,D,V,k){let{opaque:z,transmissive:dt,transparent:bt}=w;M.setupLightsView(V),Ce===!0&&K.setGlobalState(P.clippingPlanes,V),k&&pt.viewport(tt.copy(k)),z.length>0&&Sa(z,D,V),dt.length>0&&Sa(dt,D,V),bt.length>0&&Sa(bt,D,V),pt.buffers.depth.setTest(!0),pt.buffers.depth.setMask(!0),pt.buffers.color.setMask(!0),pt.setPolygonOffset(!1)}function Ef(w,D,V,k){if((V.isScene===!0?V.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[k.id]===void 0){let St=ye.has("EXT_color_buffer_half_float")||ye.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[k.id]=new wn(1,1,{generateMipmaps:!0,type:St?Kn:mn,minFilter:Ti,samples:Math.max(4,_e.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:jt.workingColorSpace})}let dt=M.state.transmissionRenderTarget[k.id],bt=k.viewport||tt;dt.setSize(bt.z*P.transmissionResolutionScale,bt.w*P.transmissionResolutionScale);let ct=P.getRenderTarget(),vt=P.getActiveCubeFace(),Tt=P.getActiveMipmapLevel();P.setRenderTarget(dt),P.getClearColor(Z),gt=P.getClearAlpha(),gt<1&&P.setClearColor(16777215,.5),P.clear(),Cn&&I.render(V);let Gt=P.toneMapping;P.toneMapping=ai;let Kt=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),M.setupLightsView(k),Ce===!0&&K.setGlobalState(P.clippingPlanes,k),Sa(w,V,k),zt.updateMultisampleRenderTarget(dt),zt.updateRenderTargetMipmap(dt),ye.has("WEBGL_multisampled_render_to_texture")===!1){let St=!1;for(let Jt=0,Ae=D.length;Jt<Ae;Jt++){let ge=D[Jt],{object:pe,geometry:Ze,material:Mt,group:nn}=ge;if(Mt.side===pn&&pe.layers.test(k.layers)){let se=Mt.side;Mt.side=hn,Mt.needsUpdate=!0,Af(pe,V,k,Ze,Mt,nn),Mt.side=se,Mt.needsUpdate=!0,St=!0}}St===!0&&(zt.updateMultisampleRenderTarget(dt),zt.updateRenderTargetMipmap(dt))}P.setRenderTarget(ct,vt,Tt),P.setClearColor(Z,gt),Kt!==void 0&&(k.viewport=Kt),P.toneMapping=Gt}function Sa(w,D,V){let k=D.isScene===!0?D.overrideMaterial:null;for(let z=0,dt=w.length;z<dt;z++){let bt=w[z],{object:ct,geometry:vt,group:Tt}=bt,Gt=bt.material;Gt.allowOverride===!0&&k!==null&&(Gt=k),ct.layers.test(V.layers)&&Af(ct,D,V,vt,Gt,Tt)}}function Af(w,D,V,k,z,dt){F!==null&&z.isNodeMaterial&&F.setObject(w,z),w.onBeforeRender(P,D,V,k,z,dt),w.modelViewMatrix.multiplyMatrices(V.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),z.onBeforeRender(P,D,V,k,w,dt),z.transparent===!0&&z.side===pn&&z.forceSinglePass===!1?(z.side=hn,z.needsUpdate=!0,P.renderBufferDirect(V,D,k,z,w,dt),z.side=Zi,z.needsUpdate=!0,P.renderBufferDirect(V,D,k,z,w,dt),z.side=pn):P.renderBufferDirect(V,D,k,z,w,dt),w.onAfterRender(P,D,V,k,z,dt)}function Rf(w){let D=0;for(let V of w)V.texture!==null&&D++;return D}function Br(w,D,V){D.isScene!==!0&&(D=Rn);let k=Dt.get(w),z=M.state.lights,dt=M.state.shadowsArray,bt=z.state.version,ct=j.getParameters(w,z.state,dt,D,V,M.state.lightProbeGridArray),vt=j.getProgramCacheKey(ct),Tt=k.programs;k.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?D.environment:null,k.fog=D.fog;let Gt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;k.envMap=R.get(w.envMap||k.environment,Gt),k.envMapRotation=k.environment!==null&&w.envMap===null?D.environmentRotation:w.envMapRotation,Tt===void 0&&(w.addEventListener("dispose",he),Tt=new Map,k.programs=Tt,k.programVariants=new Map);let Kt=Tt.get(vt);if(Kt!==void 0){if(k.currentProgram===Kt&&k.lightsStateVersion===bt)return Pf(w,ct),Kt}else ct.uniforms=j.getUniforms(w),F!==null&&w.isNodeMaterial&&F.build(w,V,ct),w.onBeforeCompile(ct,P),Kt=j.acquireProgram(ct,vt),Tt.set(vt,Kt),k.uniforms=ct.uniforms;let St=k.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(St.clippingPlanes=K.uniform),Pf(w,ct),k.needsLights=X0(w),k.lightsStateVersion=bt,k.needsLights&&(St.ambientLightColor.value=z.state.ambient,St.lightProbe.value=z.state.probe,St.sunLights.value=z.state.sun,St.sunLightShadows.value=z.state.sunShadow,St.directionalLights.value=z.state.directional,St.directionalLightShadows.value=z.state.directionalShadow,St.spotLights.value=z.state.spot,St.spotLightShadows.value=z.state.spotShadow,St.rectAreaLights.value=z.state.rectArea,St.ltc_1.value=z.state.rectAreaLTC1,St.ltc_2.value=z.state.rectAreaLTC2,St.pointLights.value=z.state.point,St.pointLightShadows.value=z.state.pointShadow,St.hemisphereLights.value=z.state.hemi,St.sunShadowMatrix.value=z.state.sunShadowMatrix,St.sunShadowCascade.value=z.state.sunShadowCascade,St.directionalShadowMatrix.value=z.state.directionalShadowMatrix,St.spotLightMatrix.value=z.state.spotLightMatrix,St.spotLightMap.value=z.state.spotLightMap,St.pointShadowMatrix.value=z.state.pointShadowMatrix),k.numLightProbeGrids=Rf(M.state.lightProbeGridArray),k.currentProgram=Kt,k.uniformsList=null,Kt}function V0(w,D,V,k,z){let dt=Dt.get(w),bt=dt.currentProgram.id+","+k+","+z,ct=dt.programVariants.get(bt);return ct===void 0?(ct=Br(w,D,V),dt.programVariants.set(bt,ct)):(dt.currentProgram=ct,dt.uniformsList=null,dt.outputColorSpace=k,dt.toneMapping=z),ct}function Cf(w){if(w.uniformsList===null){let D=w.currentProgram.getUniforms();w.uniformsList=_r.seqWithValue(D.seq,w.uniforms)}return w.uniformsList}function Pf(w,D){let V=Dt.get(w);V.outputColorSpace=D.outputColorSpace,V.batching=D.batching,V.batchingColor=D.batchingColor,V.instancing=D.instancing,V.instancingColor=D.instancingColor,V.instancingMorph=D.instancingMorph,V.skinning=D.skinning,V.morphTargets=D.morphTargets,V.morphNormals=D.morphNormals,V.morphColors=D.morphColors,V.morphTargetsCount=D.morphTargetsCount,V.numClippingPlanes=D.numClippingPlanes,V.numIntersection=D.numClipIntersection,V.vertexAlphas=D.vertexAlphas,V.vertexTangents=D.vertexTangents,V.toneMapping=D.toneMapping}function H0(w,D,V,k,z){D.isScene!==!0&&(D=Rn),zt.resetTextureUnits();let dt=D.fog,bt=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?D.environment:null,ct=et===null?P.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:jt.workingColorSpace,vt=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,Tt=R.get(k.envMap||bt,vt),Gt=k.vertexColors===!0&&!!V.attributes.color&&V.attributes.color.itemSize===4,Kt=!!V.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),St=!!V.morphAttributes.position,Jt=!!V.morphAttributes.normal,Ae=!!V.morphAttributes.color,ge=ai;k.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(ge=P.toneMapping);let pe=V.morphAttributes.position||V.morphAttributes.normal||V.morphAttributes.color,Ze=pe!==void 0?pe.length:0,Mt=Dt.get(k),nn=M.state.lights;if(Ce===!0&&(dn===!0||w!==Q)){let Se=w===Q&&k.id===X;K.setState(k,w,Se)}let se=!1,rs=!1;k.version===Mt.__version?Mt.needsLights&&Mt.lightsStateVersion!==nn.state.version||z.isBatchedMesh&&Mt.batching===!1||!z.isBatchedMesh&&Mt.batching===!0||z.isBatchedMesh&&Mt.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&Mt.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&Mt.instancing===!1||!z.isInstancedMesh&&Mt.instancing===!0||z.isSkinnedMesh&&Mt.skinning===!1||!z.isSkinnedMesh&&Mt.skinning===!0||z.isInstancedMesh&&Mt.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Mt.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Mt.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Mt.instancingMorph===!1&&z.morphTexture!==null||Mt.envMap!==Tt||k.fog===!0&&Mt.fog!==dt||Mt.numClippingPlanes!==void 0&&(Mt.numClippingPlanes!==K.numPlanes||Mt.numIntersection!==K.numIntersection)||Mt.vertexAlphas!==Gt||Mt.vertexTangents!==Kt||Mt.morphTargets!==St||Mt.morphNormals!==Jt||Mt.morphColors!==Ae||Mt.morphTargetsCount!==Ze||Mt.numLightProbeGrids!==Rf(M.state.lightProbeGridArray)?se=!0:(Mt.outputColorSpace!==ct||Mt.toneMapping!==ge)&&(rs=!0):(se=!0,Mt.__version=k.version);let Ke=Mt.currentProgram;(se===!0||rs===!0)&&(Ke=rs===!0?V0(k,D,z,ct,ge):Br(k,D,z),F&&k.isNodeMaterial&&F.onUpdateProgram(k,Ke,Mt));let Ma=!1,Di=!1,os=!1,ne=Ke.getUniforms(),Ge=Mt.uniforms;if(pt.useProgram(Ke.program)&&(Ma=!0,Di=!0,os=!0),k.id!==X&&(X=k.id,Di=!0),Ma||Q!==w){pt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),ne.setValue(O,"projectionMatrix",w.projectionMatrix),ne.setValue(O,"viewMatrix",w.matrixWorldInverse);let Oe=ne.map.cameraPosition;Oe!==void 0&&Oe.setValue(O,Qn.setFromMatrixPosition(w.matrixWorld)),_e.logarithmicDepthBuffer&&ne.setValue(O,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&ne.setValue(O,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,Di=!0,os=!0)}if(Mt.needsLights&&(nn.state.sunShadowMap.length>0&&ne.setValue(O,"sunShadowMap",nn.state.sunShadowMap,zt),nn.state.directionalShadowMap.length>0&&ne.setValue(O,"directionalShadowMap",nn.state.directionalShadowMap,zt),nn.state.spotShadowMap.length>0&&ne.setValue(O,"spotShadowMap",nn.state.spotShadowMap,zt),nn.state.pointShadowMap.length>0&&ne.setValue(O,"pointShadowMap",nn.state.pointShadowMap,zt)),z.isSkinnedMesh){ne.setOptional(O,z,"bindMatrix"),ne.setOptional(O,z,"bindMatrixInverse");let Se=z.skeleton;Se&&(Se.boneTexture===null&&Se.computeBoneTexture(),ne.setValue(O,"boneTexture",Se.boneTexture,zt))}z.isBatchedMesh&&(ne.setOptional(O,z,"batchingTexture"),ne.setValue(O,"batchingTexture",z._matricesTexture,zt),ne.setOptional(O,z,"batchingIdTexture"),ne.setValue(O,"batchingIdTexture",z._indirectTexture,zt),ne.setOptional(O,z,"batchingColorTexture"),z._colorsTexture!==null&&ne.setValue(O,"batchingColorTexture",z._colorsTexture,zt));let zn=V.morphAttributes;if((zn.position!==void 0||zn.normal!==void 0||zn.color!==void 0)&&J.update(z,V,Ke),(Di||Mt.receiveShadow!==z.receiveShadow)&&(Mt.receiveShadow=z.receiveShadow,ne.setValue(O,"receiveShadow",z.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&D.environment!==null&&(Ge.envMapIntensity.value=D.environmentIntensity),Ge.dfgLUT!==void 0&&(Ge.dfgLUT.value=AS()),Di){if(ne.setValue(O,"toneMappingExposure",P.toneMappingExposure),Mt.needsLights&&W0(Ge,os),dt&&k.fog===!0&&rt.refreshFogUniforms(Ge,dt),rt.refreshMaterialUniforms(Ge,k,xt,Lt,M.state.transmissionRenderTarget[w.id]),Mt.needsLights&&Mt.numLightProbeGrids>0){let Se=y,Oe=0;for(let pi of M.state.lightProbeGridArray)pi.texture!==null&&(Se.textures[Oe]=pi.texture,Se.min[Oe]=pi.boundingBox.min,Se.max[Oe]=pi.boundingBox.max,Se.resolution[Oe]=pi.resolution,Oe++);for(let pi in Se)Se[pi].length=Oe;Ge.probesSH.value=Se.textures,Ge.probesMin.value=Se.min,Ge.probesMax.value=Se.max,Ge.probesResolution.value=Se.resolution}_r.upload(O,Cf(Mt),Ge,zt)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(_r.upload(O,Cf(Mt),Ge,zt),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&ne.setValue(O,"center",z.center),ne.setValue(O,"modelViewMatrix",z.modelViewMatrix),ne.setValue(O,"normalMatrix",z.normalMatrix),ne.setValue(O,"modelMatrix",z.matrixWorld),k.uniformsGroups!==void 0){let Se=k.uniformsGroups;for(let Oe=0,pi=Se.length;Oe<pi;Oe++){let Lf=Se[Oe];At.update(Lf,Ke),At.bind(Lf,Ke)}}return Ke}function W0(w,D){w.ambientLightColor.needsUpdate=D,w.lightProbe.needsUpdate=D,w.sunLights.needsUpdate=D,w.sunLightShadows.needsUpdate=D,w.directionalLights.needsUpdate=D,w.directionalLightShadows.needsUpdate=D,w.pointLights.needsUpdate=D,w.pointLightShadows.needsUpdate=D,w.spotLights.needsUpdate=D,w.spotLightShadows.needsUpdate=D,w.rectAreaLights.needsUpdate=D,w.hemisphereLights.needsUpdate=D}function X0(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(w,D,V){let k=Dt.get(w);k.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Dt.get(w.texture).__webglTexture=D,Dt.get(w.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:V,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,D){let V=Dt.get(w);V.__webglFramebuffer=D,V.__useDefaultFramebuffer=D===void 0},this.setRenderTarget=function(w,D=0,V=0){et=w,$=D,W=V;let k=null,z=!1,dt=!1;if(w){let ct=Dt.get(w);if(ct.__useDefaultFramebuffer!==void 0){pt.bindFramebuffer(O.FRAMEBUFFER,ct.__webglFramebuffer),tt.copy(w.viewport),_t.copy(w.scissor),Ot=w.scissorTest,pt.viewport(tt),pt.scissor(_t),pt.setScissorTest(Ot),X=-1;return}else if(ct.__webglFramebuffer===void 0)zt.setupRenderTarget(w);else if(ct.__hasExternalTextures)zt.rebindTextures(w,Dt.get(w.texture).__webglTexture,Dt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Gt=w.depthTexture;if(ct.__boundDepthTexture!==Gt){if(Gt!==null&&Dt.has(Gt)&&(w.width!==Gt.image.width||w.height!==Gt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");zt.setupDepthRenderbuffer(w)}}let vt=w.texture;(vt.isData3DTexture||vt.isDataArrayTexture||vt.isCompressedArrayTexture)&&(dt=!0);let Tt=Dt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Tt[D])?k=Tt[D][V]:k=Tt[D],z=!0):w.samples>0&&zt.useMultisampledRTT(w)===!1?k=Dt.get(w).__webglMultisampledFramebuffer:Array.isArray(Tt)?k=Tt[V]:k=Tt,tt.copy(w.viewport),_t.copy(w.scissor),Ot=w.scissorTest}else tt.copy(Ut).multiplyScalar(xt).floor(),_t.copy(ce).multiplyScalar(xt).floor(),Ot=fe;if(V!==0&&(k=G),pt.bindFramebuffer(O.FRAMEBUFFER,k)&&pt.drawBuffers(w,k),pt.viewport(tt),pt.scissor(_t),pt.setScissorTest(Ot),z){let ct=Dt.get(w.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+D,ct.__webglTexture,V)}else if(dt){let ct=D;for(let vt=0;vt<w.textures.length;vt++){let Tt=Dt.get(w.textures[vt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+vt,Tt.__webglTexture,V,ct)}}else if(w!==null&&V!==0){let ct=Dt.get(w.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ct.__webglTexture,V)}X=-1};function If(w){let D=Dt.get(w);return(D.__readFormat!==w.format||D.__readType!==w.type)&&(D.__readFormat=w.format,D.__readType=w.type,D.__formatReadable=_e.textureFormatReadable(w.format),D.__typeReadable=_e.textureTypeReadable(w.type)),D}this.readRenderTargetPixels=function(w,D,V,k,z,dt,bt,ct=0){if(!(w&&w.isWebGLRenderTarget)){Ft("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let vt=Dt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&bt!==void 0&&(vt=vt[bt],Array.isArray(vt)&&(vt=vt[0])),vt){pt.bindFramebuffer(O.FRAMEBUFFER,vt);try{let Tt=w.textures[ct],Gt=Tt.format,Kt=Tt.type;w.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ct);let St=If(Tt);if(St.__formatReadable===!1){Ft("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(St.__typeReadable===!1){Ft("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}D>=0&&D<=w.width-k&&V>=0&&V<=w.height-z&&O.readPixels(D,V,k,z,st.convert(Gt),st.convert(Kt),dt)}finally{let Tt=et!==null?Dt.get(et).__webglFramebuffer:null;pt.bindFramebuffer(O.FRAMEBUFFER,Tt)}}},this.readRenderTargetPixelsAsync=async function(w,D,V,k,z,dt,bt,ct=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let vt=Dt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&bt!==void 0&&(vt=vt[bt],Array.isArray(vt)&&(vt=vt[0])),vt)if(D>=0&&D<=w.width-k&&V>=0&&V<=w.height-z){pt.bindFramebuffer(O.FRAMEBUFFER,vt);let Tt=w.textures[ct],Gt=Tt.format,Kt=Tt.type;w.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ct);let St=If(Tt);if(St.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(St.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Jt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,Jt),O.bufferData(O.PIXEL_PACK_BUFFER,dt.byteLength,O.STREAM_READ),O.readPixels(D,V,k,z,st.convert(Gt),st.convert(Kt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Ae=et!==null?Dt.get(et).__webglFramebuffer:null;pt.bindFramebuffer(O.FRAMEBUFFER,Ae);let ge=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await cm(O,ge,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,Jt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,dt),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(Jt),O.deleteSync(ge),dt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,D=null,V=0){let k=Math.pow(2,-V),z=Math.floor(w.image.width*k),dt=Math.floor(w.image.height*k),bt=D!==null?D.x:0,ct=D!==null?D.y:0;zt.setTexture2D(w,0),O.copyTexSubImage2D(O.TEXTURE_2D,V,0,0,bt,ct,z,dt),pt.unbindTexture()},this.copyTextureToTexture=function(w,D,V=null,k=null,z=0,dt=0){let bt,ct,vt,Tt,Gt,Kt,St,Jt,Ae,ge=w.isCompressedTexture?w.mipmaps[dt]:w.image;if(V!==null)bt=V.max.x-V.min.x,ct=V.max.y-V.min.y,vt=V.isBox3?V.max.z-V.min.z:1,Tt=V.min.x,Gt=V.min.y,Kt=V.isBox3?V.min.z:0;else{let ne=Math.pow(2,-z);bt=Math.floor(ge.width*ne),ct=Math.floor(ge.height*ne),w.isDataArrayTexture?vt=ge.depth:w.isData3DTexture?vt=Math.floor(ge.depth*ne):vt=1,Tt=0,Gt=0,Kt=0}k!==null?(St=k.x,Jt=k.y,Ae=k.z):(St=0,Jt=0,Ae=0);let pe=st.convert(D.format),Ze=st.convert(D.type),Mt;D.isData3DTexture?(zt.setTexture3D(D,0),Mt=O.TEXTURE_3D):D.isDataArrayTexture||D.isCompressedArrayTexture?(zt.setTexture2DArray(D,0),Mt=O.TEXTURE_2D_ARRAY):(zt.setTexture2D(D,0),Mt=O.TEXTURE_2D),pt.activeTexture(O.TEXTURE0),pt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,D.flipY),pt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,D.premultiplyAlpha),pt.pixelStorei(O.UNPACK_ALIGNMENT,D.unpackAlignment);let nn=pt.getParameter(O.UNPACK_ROW_LENGTH),se=pt.getParameter(O.UNPACK_IMAGE_HEIGHT),rs=pt.getParameter(O.UNPACK_SKIP_PIXELS),Ke=pt.getParameter(O.UNPACK_SKIP_ROWS),Ma=pt.getParameter(O.UNPACK_SKIP_IMAGES);pt.pixelStorei(O.UNPACK_ROW_LENGTH,ge.width),pt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,ge.height),pt.pixelStorei(O.UNPACK_SKIP_PIXELS,Tt),pt.pixelStorei(O.UNPACK_SKIP_ROWS,Gt),pt.pixelStorei(O.UNPACK_SKIP_IMAGES,Kt);let Di=w.isDataArrayTexture||w.isData3DTexture,os=D.isDataArrayTexture||D.isData3DTexture;if(w.isDepthTexture){let ne=Dt.get(w),Ge=Dt.get(D),zn=Dt.get(ne.__renderTarget),Se=Dt.get(Ge.__renderTarget);pt.bindFramebuffer(O.READ_FRAMEBUFFER,zn.__webglFramebuffer),pt.bindFramebuffer(O.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let Oe=0;Oe<vt;Oe++)Di&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Dt.get(w).__webglTexture,z,Kt+Oe),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Dt.get(D).__webglTexture,dt,Ae+Oe)),O.blitFramebuffer(Tt,Gt,Tt+bt,Gt+ct,St,Jt,St+bt,Jt+ct,O.DEPTH_BUFFER_BIT,O.NEAREST);pt.bindFramebuffer(O.READ_FRAMEBUFFER,null),pt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(z!==0||w.isRenderTargetTexture||Dt.has(w)){let ne=Dt.get(w),Ge=Dt.get(D);pt.bindFramebuffer(O.READ_FRAMEBUFFER,L),pt.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let zn=0;zn<vt;zn++)Di?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ne.__webglTexture,z,Kt+zn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ne.__webglTexture,z),os?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ge.__webglTexture,dt,Ae+zn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ge.__webglTexture,dt),z!==0?O.blitFramebuffer(Tt,Gt,Tt+bt,Gt+ct,St,Jt,St+bt,Jt+ct,O.COLOR_BUFFER_BIT,O.NEAREST):os?O.copyTexSubImage3D(Mt,dt,St,Jt,Ae+zn,Tt,Gt,bt,ct):O.copyTexSubImage2D(Mt,dt,St,Jt,Tt,Gt,bt,ct);pt.bindFramebuffer(O.READ_FRAMEBUFFER,null),pt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else os?w.isDataTexture||w.isData3DTexture?O.texSubImage3D(Mt,dt,St,Jt,Ae,bt,ct,vt,pe,Ze,ge.data):D.isCompressedArrayTexture?O.compressedTexSubImage3D(Mt,dt,St,Jt,Ae,bt,ct,vt,pe,ge.data):O.texSubImage3D(Mt,dt,St,Jt,Ae,bt,ct,vt,pe,Ze,ge):w.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,dt,St,Jt,bt,ct,pe,Ze,ge.data):w.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,dt,St,Jt,ge.width,ge.height,pe,ge.data):O.texSubImage2D(O.TEXTURE_2D,dt,St,Jt,bt,ct,pe,Ze,ge);pt.pixelStorei(O.UNPACK_ROW_LENGTH,nn),pt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,se),pt.pixelStorei(O.UNPACK_SKIP_PIXELS,rs),pt.pixelStorei(O.UNPACK_SKIP_ROWS,Ke),pt.pixelStorei(O.UNPACK_SKIP_IMAGES,Ma),dt===0&&D.generateMipmaps===!0&&D.mipmapsAutoUpdate===!0&&O.generateMipmap(Mt),pt.unbindTexture()},this.initRenderTarget=function(w){Dt.get(w).__webglFramebuffer===void 0&&zt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?zt.setTextureCube(w,0):w.isData3DTexture?zt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?zt.setTexture2DArray(w,0):zt.setTexture2D(w,0),pt.unbindTexture()},this.resetState=function(){$=0,W=0,et=null,pt.reset(),ot.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Dn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=jt._getDrawingBufferColorSpace(t),e.unpackColorSpace=jt._getUnpackColorSpace()}};var Km="wisch-theme",Jm=()=>document.documentElement,Ed=new Set,$c=!1,Ad=null,RS=()=>{try{let i=localStorage.getItem(Km);return i==="light"||i==="dark"?i:null}catch{return null}};function ws(){return $c?"light":Ad??(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function jm(i){Ad=i;try{localStorage.setItem(Km,i)}catch{}Wc()}function wr(i){return Ed.add(i),()=>Ed.delete(i)}function Wc(){Jm().dataset.theme=ws(),Xc=null;for(let i of Ed)i()}function Qm(){Ad=RS(),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",Wc);let i=t=>{$c!==t&&($c=t,Wc())};matchMedia("print").addEventListener("change",({matches:t})=>i(t)),addEventListener("beforeprint",()=>i(!0)),addEventListener("afterprint",()=>i(!1)),Wc()}var Sr=()=>$c,Xc=null;function Et(i){Xc??=new Map;let t=Xc.get(i);return t===void 0&&(t=getComputedStyle(Jm()).getPropertyValue(`--${i}`).trim()||"#888888",Xc.set(i,t)),t}function tg(i,t=Math.PI/3){let e=i.index?i.toNonIndexed():i,n=e.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let y=0;y<s;y++)r[3*y+0]=n.getX(y),r[3*y+1]=n.getY(y),r[3*y+2]=n.getZ(y)}let o=Math.cos(t),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let y=0;y<l;y++){let E=9*y,M=r[E+0],v=r[E+1],T=r[E+2],N=r[E+3],P=r[E+4],U=r[E+5],F=r[E+6],G=r[E+7],L=r[E+8],H=F-N,$=G-P,W=L-U,et=M-N,X=v-P,Q=T-U,tt=$*Q-W*X,_t=W*et-H*Q,Ot=H*X-$*et,Z=1/(Math.sqrt(tt*tt+_t*_t+Ot*Ot)||1);c[3*y+0]=tt*Z,c[3*y+1]=_t*Z,c[3*y+2]=Ot*Z}let h=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,p=new Int32Array(d),x=0;for(let y=0;y<s;y++){let E=3*y,M=Math.trunc(r[E+0]*a),v=Math.trunc(r[E+1]*a),T=Math.trunc(r[E+2]*a),N=(Math.imul(M,73856093)^Math.imul(v,19349663)^Math.imul(T,83492791))&f;for(;;){let P=p[N];if(P===0){let F=3*x;u[F+0]=M,u[F+1]=v,u[F+2]=T,p[N]=x+1,h[y]=x++;break}let U=3*(P-1);if(u[U+0]===M&&u[U+1]===v&&u[U+2]===T){h[y]=P-1;break}N=N+1&f}}let m=new Int32Array(x+1);for(let y=0;y<s;y++)m[h[y]+1]++;for(let y=0;y<x;y++)m[y+1]+=m[y];let g=new Int32Array(s),b=m.slice(0,x);for(let y=0;y<l;y++){let E=3*y;g[b[h[E+0]]++]=y,g[b[h[E+1]]++]=y,g[b[h[E+2]]++]=y}let A=new Float32Array(s*3);for(let y=0;y<l;y++){let E=3*y,M=c[E+0],v=c[E+1],T=c[E+2];for(let N=0;N<3;N++){let P=E+N,U=h[P],F=0,G=0,L=0;for(let $=m[U],W=m[U+1];$<W;$++){let et=3*g[$],X=c[et+0],Q=c[et+1],tt=c[et+2];M*X+v*Q+T*tt>o&&(F+=X,G+=Q,L+=tt)}let H=1/(Math.sqrt(F*F+G*G+L*L)||1);A[3*P+0]=F*H,A[3*P+1]=G*H,A[3*P+2]=L*H}}return e.setAttribute("normal",new be(A,3,!1)),e}var CS=new C(1,1,1),PS=.7;function Te([i,t,e,n,s,r,o],a=new te){return a.compose(new C(i,t,e),new an(n,s,r,o).normalize(),CS)}function En(i,t){return i.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      gl_Position.z = (projectionMatrix * vec4(${t.toFixed(3)} * mvPosition.xyz, 1.0)).z / ${t.toFixed(3)};`)},i.customProgramCacheKey=()=>`shifted ${t}`,i}var eg=new WeakMap;function IS(i){if(!i)return new Ht;let t=eg.get(i);if(!t){let e=new Ht;e.setAttribute("position",new be(Float32Array.from(i.vertices,n=>n/Pa),3)),e.setIndex(i.triangles),t=tg(e,PS),eg.set(i,t)}return t}function Mr(i,t){switch(i.kind){case"box":return new Vi(...i.size);case"sphere":return new Ro(i.radius,28,18);case"cylinder":return new Hi(i.radius,i.radius,i.length,32).rotateX(Math.PI/2);case"capsule":return new mo(i.radius,i.length,10,28).rotateX(Math.PI/2);case"mesh":return IS(t[i.mesh]);default:return new Ht}}var ng=new WeakMap;function na(i){let t=ng.get(i);if(t)return t;let[e,n]=[Math.cos(i.axis_rad),Math.sin(i.axis_rad)],[s,r]=[Math.cos(i.half_angle_rad),Math.sin(i.half_angle_rad)*Math.sign(i.radius_m)],o={along:[e,n],cosine:s,sine:r,slant:i.radius_m/r,axis:new C(s*e,s*n,-r),radial:new C(r*e,r*n,s),across:new C(-n,e,0)};return ng.set(i,o),o}function LS(i,t,e){let{along:n,slant:s}=na(i);return Math.atan2(n[0]*e-n[1]*t,s+n[0]*t+n[1]*e)}function ig(i,t,e){return LS(i,t,e)/na(i).sine}function sg(i,t,e,n){let{along:s,slant:r,sine:o,cosine:a,axis:l,radial:c,across:h}=na(i),[u,d]=[s[0]*t+s[1]*e,s[0]*e-s[1]*t],f=(u*(2*r+u)+d*d)/(Math.hypot(r+u,d)+r),p=Math.atan2(d,r+u)/o,x=h.clone().multiplyScalar(Math.sin(p)).addScaledVector(c,-2*Math.sin(p/2)**2),m=x.clone().add(c);return x.multiplyScalar(i.radius_m).addScaledVector(l,a*f).addScaledVector(m,o*f).addScaledVector(m,a*n).addScaledVector(l,-o*n).toArray()}function rg(i,t){let{sine:e,cosine:n,axis:s,radial:r,across:o}=na(i),[a,l]=[r.dot(t)+i.radius_m,o.dot(t)];return r.clone().multiplyScalar(a).addScaledVector(o,l).multiplyScalar(Math.sign(i.radius_m)).normalize().multiplyScalar(n).addScaledVector(s,-e)}function og(i,t){let{along:e,slant:n,sine:s}=na(i),[r,o]=[Math.sin(t*s),Math.cos(t*s)];return(a,l)=>Math.sign(s)*(o*(e[0]*l-e[1]*a)-r*(n+e[0]*a+e[1]*l))}var Rd=class{constructor(t){this.shape=t;let{points:e,places:n,triangles:s}=t;this.geometry=new Ht,this.geometry.setAttribute("position",new be(Float32Array.from(e),3)),this.geometry.setIndex([...s]),this.geometry.computeVertexNormals(),this.normals=this.geometry.getAttribute("normal").array;let r=[-1/0,-1/0];for(let a=0;a<n.length;a++)this.low[a%2]=Math.min(this.low[a%2],n[a]),r[a%2]=Math.max(r[a%2],n[a]);let o=[r[0]-this.low[0],r[1]-this.low[1]];this.cell=Math.max(Math.sqrt(3*o[0]*o[1]/Math.max(s.length,1)),1e-4),this.columns=Math.floor(o[0]/this.cell)+1;for(let a=0;a<s.length;a+=3){let l=[0,1,2].map(u=>s[a+u]);l.forEach(u=>this.triangleOf[u]??=a);let[c,h]=[0,1].map(u=>{let d=l.map(f=>Math.floor((n[2*f+u]-this.low[u])/this.cell));return[Math.min(...d),Math.max(...d)]});for(let u=h[0];u<=h[1];u++)for(let d=c[0];d<=c[1];d++)(this.cells[u*this.columns+d]??=[]).push(a)}}shape;geometry;normals;low=[1/0,1/0];cell;columns;cells=[];triangleOf=[];lift(t,e,n){let s=this.find(t,e),r=this.mean(this.shape.points,s),o=this.mean(this.normals,s).normalize();return r.addScaledVector(o,n).toArray()}normalNear(t){let{points:e}=this.shape,[n,s]=[0,1/0];for(let r=0;r<e.length;r+=3){let o=(e[r]-t.x)**2+(e[r+1]-t.y)**2+(e[r+2]-t.z)**2;o<s&&([n,s]=[r,o])}return new C().fromArray(this.normals,n)}mean(t,{corners:e,weights:n}){let s=new C;return e.forEach((r,o)=>s.addScaledVector(new C(t[3*r],t[3*r+1],t[3*r+2]),n[o])),s}find(t,e){let[n,s]=[Math.floor((t-this.low[0])/this.cell),Math.floor((e-this.low[1])/this.cell)],r=n>=0&&n<this.columns&&s>=0?this.cells[s*this.columns+n]??[]:[];for(let c of r){let h=this.locate(c,t,e);if(h.weights.every(u=>u>=-1e-6))return h}let{places:o}=this.shape,[a,l]=[0,1/0];for(let c=0;c<this.triangleOf.length;c++){let h=(o[2*c]-t)**2+(o[2*c+1]-e)**2;h<l&&([a,l]=[c,h])}return this.locate(this.triangleOf[a]??0,t,e)}locate(t,e,n){let{places:s,triangles:r}=this.shape,o=[r[t],r[t+1],r[t+2]],[a,l,c,h,u,d]=o.flatMap(m=>[s[2*m],s[2*m+1]]),f=(c-a)*(d-l)-(h-l)*(u-a),p=((e-a)*(d-l)-(n-l)*(u-a))/f,x=((c-a)*(n-l)-(h-l)*(e-a))/f;return{corners:o,weights:[1-p-x,p,x]}}},ag=new WeakMap;function ia(i){let t=ag.get(i);if(t)return t;let e=new Rd(i);return ag.set(i,e),e}var Cd=.05,cg=.02;function Ld({axis_rad:i}){let[t,e]=[Math.cos(i),Math.sin(i)];return[[t,e],[-e,t]]}function Pd(i,t,e){if(i.kind==="cone")return ig(i,t,e);let[,n]=Ld(i);return(n[0]*t+n[1]*e)/i.radius_m}function DS(i,t,e){return i.kind==="mesh"?Math.ceil(Math.hypot(e[0]-t[0],e[1]-t[1])/cg):Math.ceil(Math.abs(Pd(i,e[0],e[1])-Pd(i,t[0],t[1]))/Cd)}function Ji(i,t,e,n){if(!i)return[t,e,n];if(i.kind==="mesh")return ia(i).lift(t,e,n);if(i.kind==="cone")return sg(i,t,e,n);let[s,r]=Ld(i),o=s[0]*t+s[1]*e,a=(r[0]*t+r[1]*e)/i.radius_m,l=(i.radius_m+n)*Math.sin(a);return[s[0]*o+r[0]*l,s[1]*o+r[1]*l,n*Math.cos(a)-2*i.radius_m*Math.sin(a/2)**2]}function ji({pose:i,shape:t},e){let n=Te(i),s=new C(0,0,1),r=e.clone().applyMatrix4(n.clone().invert());if(t?.kind==="mesh")s.copy(ia(t).normalNear(r));else if(t?.kind==="cone")s.copy(rg(t,r));else if(t){let[,o]=Ld(t),[a,l]=[o[0]*r.x+o[1]*r.y,r.z+t.radius_m];s.set(o[0]*a,o[1]*a,l).multiplyScalar(Math.sign(t.radius_m)).normalize()}return s.transformDirection(n)}function Tr(i,t,e){if(!i)return[...t];let n=[];for(let s=0;s<t.length;s++){let[r,o,a]=t[s],l=s+1<t.length?t[s+1]:e?t[0]:null,c=l?Math.max(1,DS(i,t[s],l)):1;for(let h=0;h<c;h++){let u=h/c,d=l??t[s];n.push(Ji(i,r+u*(d[0]-r),o+u*(d[1]-o),a+u*(d[2]-a)))}}return n}function lg(i,t){let e=[];return i.forEach((n,s)=>{let r=i[(s+1)%i.length],[o,a]=[t(n),t(r)];if(o>=0&&e.push(n),o>=0!=a>=0){let l=o/(o-a);e.push([n[0]+l*(r[0]-n[0]),n[1]+l*(r[1]-n[1]),n[2]+l*(r[2]-n[2])])}}),e}function NS(i){let t=([n,s])=>Pd(i,n,s)/Cd,e=n=>{if(i.kind==="cylinder")return r=>t(r)-n;let s=og(i,n*Cd);return([r,o])=>s(r,o)};return(n,s)=>{let r=n.map(t),o=Math.floor(Math.min(...r));for(let a=o;a<Math.max(...r,o+.5);a++){let[l,c]=[e(a),e(a+1)],h=lg(lg(n,l),u=>-c(u));for(let u=1;u+1<h.length;u++)s([h[0],h[u],h[u+1]])}}}function Id([i,t,e],n){let s=[[i,t],[t,e],[e,i]].map(([h,u])=>Math.hypot(h[0]-u[0],h[1]-u[1])),r=s.indexOf(Math.max(...s));if(s[r]<=cg)return n([i,t,e]);let[o,a,l]=[[i,t,e],[t,e,i],[e,i,t]][r],c=[(o[0]+a[0])/2,(o[1]+a[1])/2,(o[2]+a[2])/2];Id([o,c,l],n),Id([c,a,l],n)}function Dd(i,t){if(!i)return t;let e=t.index?t.toNonIndexed():t,{array:n,count:s}=e.getAttribute("position"),r=[],o=i.kind==="mesh"?Id:NS(i),a=c=>{for(let[h,u,d]of c)r.push(...Ji(i,h,u,d))};for(let c=0;c+2<s;c+=3){let h=u=>[n[3*(c+u)],n[3*(c+u)+1],n[3*(c+u)+2]];o([h(0),h(1),h(2)],a)}let l=new Ht;return l.setAttribute("position",new be(Float32Array.from(r),3)),l.computeVertexNormals(),t.dispose(),l}ft.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new ht},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};un.line={uniforms:Jo.merge([ft.common,ft.fog,ft.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var en=class extends On{constructor(t){super({type:"LineMaterial",uniforms:Jo.clone(un.line.uniforms),vertexShader:un.line.vertexShader,fragmentShader:un.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var hg=new cn,qc=new C,Ss=class extends Bo{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Nt(t,3)),this.setAttribute("uv",new Nt(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new qn(e,6,1);return this.setAttribute("instanceStart",new We(n,3,0)),this.setAttribute("instanceEnd",new We(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new qn(e,6,1);return this.setAttribute("instanceColorStart",new We(n,3,0)),this.setAttribute("instanceColorEnd",new We(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new Po(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new cn);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),hg.setFromBufferAttribute(e),this.boundingBox.union(hg))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new fn),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)qc.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(qc)),qc.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(qc));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var Nd=new le,ug=new C,dg=new C,Xe=new le,$e=new le,ci=new le,Ud=new C,Od=new te,qe=new zo,fg=new C,Yc=new cn,Zc=new fn,hi=new le,ui,Ms;function pg(i,t,e){return hi.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),hi.multiplyScalar(1/hi.w),hi.x=Ms/e.width,hi.y=Ms/e.height,hi.applyMatrix4(i.projectionMatrixInverse),hi.multiplyScalar(1/hi.w),Math.abs(Math.max(hi.x,hi.y))}function US(i,t){let e=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){qe.start.fromBufferAttribute(s,a),qe.end.fromBufferAttribute(r,a),qe.applyMatrix4(e);let c=new C,h=new C;ui.distanceSqToSegment(qe.start,qe.end,h,c),h.distanceTo(c)<Ms*.5&&t.push({point:h,pointOnLine:c,distance:ui.origin.distanceTo(h),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function OS(i,t,e){let n=t.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),u=-t.near;ui.at(1,ci),ci.w=1,ci.applyMatrix4(t.matrixWorldInverse),ci.applyMatrix4(n),ci.multiplyScalar(1/ci.w),ci.x*=r.x/2,ci.y*=r.y/2,ci.z=0,Ud.copy(ci),Od.multiplyMatrices(t.matrixWorldInverse,o);for(let d=0,f=h;d<f;d++){if(Xe.fromBufferAttribute(l,d),$e.fromBufferAttribute(c,d),Xe.w=1,$e.w=1,Xe.applyMatrix4(Od),$e.applyMatrix4(Od),Xe.z>u&&$e.z>u)continue;if(Xe.z>u){let A=Xe.z-$e.z,y=(Xe.z-u)/A;Xe.lerp($e,y)}else if($e.z>u){let A=$e.z-Xe.z,y=($e.z-u)/A;$e.lerp(Xe,y)}Xe.applyMatrix4(n),$e.applyMatrix4(n),Xe.multiplyScalar(1/Xe.w),$e.multiplyScalar(1/$e.w),Xe.x*=r.x/2,Xe.y*=r.y/2,$e.x*=r.x/2,$e.y*=r.y/2,qe.start.copy(Xe),qe.start.z=0,qe.end.copy($e),qe.end.z=0;let x=qe.closestPointToPointParameter(Ud,!0);qe.at(x,fg);let m=yr.lerp(Xe.z,$e.z,x),g=m>=-1&&m<=1,b=Ud.distanceTo(fg)<Ms*.5;if(g&&b){qe.start.fromBufferAttribute(l,d),qe.end.fromBufferAttribute(c,d),qe.start.applyMatrix4(o),qe.end.applyMatrix4(o);let A=new C,y=new C;ui.distanceSqToSegment(qe.start,qe.end,y,A),e.push({point:y,pointOnLine:A,distance:ui.origin.distanceTo(y),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var sa=class extends re{constructor(t=new Ss,e=new en({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)ug.fromBufferAttribute(e,o),dg.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+ug.distanceTo(dg);let r=new qn(s,2,1);return t.setAttribute("instanceDistanceStart",new We(r,1,0)),t.setAttribute("instanceDistanceEnd",new We(r,1,1)),this}raycast(t,e){let n=this.material.worldUnits,s=t.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;ui=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Ms=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Zc.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Ms*.5;else{let u=Math.max(s.near,Zc.distanceToPoint(ui.origin));c=pg(s,u,l.resolution)}if(Zc.radius+=c,ui.intersectsSphere(Zc)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Yc.copy(a.boundingBox).applyMatrix4(o);let h;if(n)h=Ms*.5;else{let u=Math.max(s.near,Yc.distanceToPoint(ui.origin));h=pg(s,u,l.resolution)}Yc.expandByScalar(h),ui.intersectsBox(Yc)!==!1&&(n?US(this,e):OS(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(Nd),this.material.uniforms.resolution.value.set(Nd.z,Nd.w))}};var FS={polygonOffset:!0,polygonOffsetFactor:-4,polygonOffsetUnits:-4};function di(i,t){let e=new Ss;e.setPositions(i.length?Float32Array.from(i):new Float32Array(6));let n=new sa(e,t);return n.frustumCulled=!1,n.visible=i.length>0,n}function Er(i,t){let e=[];for(let n=0;n+(t?0:1)<i.length;n++)e.push(...i[n],...i[(n+1)%i.length]);return e}var kS=2e3;function mg(i,t){let e=[],n=0,s=c=>Math.hypot(i[c+3]-i[c],i[c+4]-i[c+1],i[c+5]-i[c+2]),r=0;for(let c=0;c+5<i.length;c+=6)r+=s(c);let o=Math.max(1,r/(kS*(t[0]+t[1]))),[a,l]=[o*t[0],o*t[1]];for(let c=0;c+5<i.length;c+=6){let h=d=>[0,1,2].map(f=>i[c+f]+d*(i[c+3+f]-i[c+f])),u=s(c);for(let d=-(n%(a+l));d<u;d+=a+l){let[f,p]=[Math.max(0,d),Math.min(u,d+a)];p>f&&e.push(...h(f/u),...h(p/u))}n+=u}return e}var Kc=class{constructor(t,e){this.palette=e;let n=new en({linewidth:t,vertexColors:!0,...FS});this.line=new sa(new Ss,n),this.line.frustumCulled=!1,this.line.visible=!1}palette;line;positions=new Float32Array(6*256);colours=new Float32Array(6*256);kinds=new Uint8Array(256);changed=!0;count=0;push(t,e){this.count===this.kinds.length&&this.reserve(),this.positions.set(t,6*this.count),this.kinds[this.count]=e,this.colour(this.count++),this.changed=!0}end(t){return new C(this.positions[6*t+3],this.positions[6*t+4],this.positions[6*t+5])}paint(t){this.palette=t;for(let e=0;e<this.count;e++)this.colour(e);this.changed=!0}show(t){this.changed&&this.upload(),this.line.geometry.instanceCount=Math.min(t,this.count),this.line.visible=t>0}dispose(){this.line.geometry.dispose(),this.line.material.dispose()}colour(t){let{r:e,g:n,b:s}=this.palette[this.kinds[t]];this.colours.set([e,n,s,e,n,s],6*t)}upload(){this.changed=!1;let{geometry:t}=this.line;t.dispose();let e=new qn(this.positions.slice(0,6*Math.max(1,this.count)),6,1);t.setAttribute("instanceStart",new We(e,3,0)),t.setAttribute("instanceEnd",new We(e,3,3));let n=new qn(this.colours.slice(0,6*Math.max(1,this.count)),6,1);t.setAttribute("instanceColorStart",new We(n,3,0)),t.setAttribute("instanceColorEnd",new We(n,3,3))}reserve(){let t=n=>{let s=new Float32Array(2*n.length);return s.set(n),s};[this.positions,this.colours]=[t(this.positions),t(this.colours)];let e=new Uint8Array(2*this.kinds.length);e.set(this.kinds),this.kinds=e}};var BS={axis:"",rounds:"Round",phases:"Phase, stroke",contact:"Contact",events:"Events",force:"Force [N]",height:"Height [mm]",performance:`Performance
[%]`},zS={axis:20,rounds:20,phases:18,contact:12,events:18,force:74,height:50,performance:88},ra=[3,2],gg=[1,4],Fd=new Set(["force","height","performance"]),GS=4,Jc=class{constructor(t){this.names=t}names;lanes=[];left=112;right=22;width=600;height=0;from=0;to=1;layOut(t,e){this.width=t;let n=t<560;this.left=n?34:112;let s=0;this.lanes=this.names.map(r=>{let o=Fd.has(r);n&&o&&(s+=13);let a={name:r,label:BS[r],top:s,height:Math.round(zS[r]*(o&&e?.66:1))};return s+=a.height+GS+(o?4:0),a}),this.height=s}get narrow(){return this.left<100}get span(){return this.width-this.left-this.right}x(t){return this.left+(t-this.from)/(this.to-this.from)*this.span}t(t){return this.from+(t-this.left)/this.span*(this.to-this.from)}lane(t){return this.lanes.find(e=>e.name===t)}},VS=[.01,.02,.05,.1,.2,.5,1,2,5,10,20,30,60,120,300,600,1200,1800,3600,7200];function jc(i,t,e){let n=VS.find(r=>(t-i)/r<=e)??(t-i)/e,s=[];for(let r=Math.ceil(i/n-1e-9);r*n<=t+1e-9;r++)s.push(r*n);return{step:n,times:s}}function xg(i,t,e){let n=(t-i)/e,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=n*.999)??n,o=[];for(let a=Math.ceil(i/r-1e-9);a*r<=t+1e-9*r;a++)o.push(a*r);return o}var jn=(i,t=11,e=400)=>{i.font=`${e} ${t}px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif`};function Ts(i,t,e,n,s){if(s<14)return;let r=t.length>200?t.slice(0,200):t;if(i.measureText(r).width>s){for(;r.length>1&&i.measureText(`${r}\u2026`).width>s;)r=r.slice(0,-1);if(r.length<3)return;r+="\u2026"}i.fillText(r,e,n)}function Ye(i,t,e,n,s,r,o=1){i.strokeStyle=Et(r),i.lineWidth=o,i.beginPath(),i.moveTo(t,e),i.lineTo(n,s),i.stroke()}var HS=1.12,WS=1.8,vg=16,XS=[.45,.7,.95];function kd(i,t){for(let e of i)if(e.visible){if(e instanceof re){let n=e.geometry;n.boundingBox||n.computeBoundingBox(),n.boundingBox.isEmpty()||t(e,n.boundingBox)}kd(e.children,t)}}function Es(i){let t=[];return kd(i,({matrixWorld:e},{min:n,max:s})=>{for(let r=0;r<8;r++)t.push(new C(r&1?s.x:n.x,r&2?s.y:n.y,r&4?s.z:n.z).applyMatrix4(e))}),t}function Qc(i){let t=[];return kd(i,({matrixWorld:e},n)=>t.push({blockFromWorld:e.clone().invert(),box:n})),t}function Bd({blockFromWorld:i,box:t},e,n){let s=e.clone().applyMatrix4(i),r=n.clone().applyMatrix4(i).sub(s),o=new si(s,r.clone().normalize()).intersectBox(t,new C);return t.containsPoint(s)||o!==null&&o.distanceTo(s)<r.length()}function yg(i,t,e){return i.length?i.filter(n=>{let s=n.clone().addScaledVector(t,WS);return!e.some(r=>Bd(r,n,s))}).length/i.length:1}function _g(i,t,e,n){let[s,r]=[n,-1/0];for(let o of XS)for(let a=0;a<vg;a++){let l=2*Math.PI*a/vg,c=new C(Math.cos(o)*Math.cos(l),Math.cos(o)*Math.sin(l),Math.sin(o)),h=c.dot(e);if(h<.2)continue;let u=0;for(let{blocks:f,tool:p}of i)u+=(3*yg(p,c,f)+2*yg(t,c,f))/i.length;let d=u+2*Math.min(h,.8)+.6*c.dot(n);d>r&&([s,r]=[c,d])}return s}var th=i=>i.reduce((t,e)=>t.addScaledVector(e,1/i.length),new C);function eh(i,t,{high:e,wide:n}){if(!i.length)return null;let s=t.clone().normalize(),r=new C().crossVectors(new C(0,0,1),s).normalize(),o=new C().crossVectors(s,r),a=h=>{let u=i.map(d=>d.dot(h));return(Math.min(...u)+Math.max(...u))/2},l=new C().addScaledVector(r,a(r)).addScaledVector(o,a(o)).addScaledVector(s,a(s)),c=()=>Math.max(.1,...i.map(h=>{let u=h.clone().sub(l);return u.dot(s)+HS*Math.max(Math.abs(u.dot(r))/n,Math.abs(u.dot(o))/e)}));for(let h=0;h<3;h++){let u=c(),d=x=>{let m=i.map(g=>{let b=g.clone().sub(l);return b.dot(x)/Math.max(.05,u-b.dot(s))});return(Math.min(...m)+Math.max(...m))/2*u},[f,p]=[d(r),d(o)];l.addScaledVector(r,f).addScaledVector(o,p)}return{target:l,eye:l.clone().addScaledVector(s,c())}}var Ci=256,$S=.24,zd=4,qS=.04,YS=.05,Pi=null;function bg(){if(Pi)return Pi;let i=document.createElement("canvas");i.width=i.height=Ci;let t=i.getContext("2d"),e=t.createImageData(Ci,Ci);for(let n=0;n<Ci;n++)for(let s=0;s<Ci;s++){let r=Math.floor(zd*n/Ci),o=2*Math.PI*s/Ci,a=n+5*Math.sin(o+2.1*r)+2*Math.sin(2*o+r),l=.5+.25*Math.sin(.55*a+3*r)+.25*Math.sin(1.63*a+r),c=zd*n%Ci<zd?.06:0,h=255*(1-qS*Math.abs(Math.sin(5.3*r+1))-YS*l**3-c);e.data.set([h,h,h,255],4*(Ci*n+s))}return t.putImageData(e,0,0),Pi=new oi(i),Pi.wrapS=Pi.wrapT=nr,Pi.repeat.setScalar(1/$S),Pi.colorSpace=He,Pi.anisotropy=4,Pi}var Fn=.0015,wg=.005,ZS=.2,KS=.03,JS=/board|table|wood|desk|counter/i;function nh(i,t=Fn){let e=Ve(i);return Array.from({length:e.length/2},(n,s)=>[e[2*s],e[2*s+1],t])}var ih=class{constructor(t,{head:e,meshes:n}){this.round=t;let{plan:s}=t;this.group.add(this.bodies);for(let{part:r,...o}of s.scene){let a=Mr(o,n),l=r==="obstacle",c=new re(a,this.keep(En(new Mn,1.015),l?"obstacle":"carrier"));c.receiveShadow=c.castShadow=!0,l&&this.obstacles.push(c);let h=this.own(new xo(a,30)),u=new lr(h,this.keep(En(new ds({transparent:!0,opacity:.4}),1.01),"obstacle-line"));o.kind!=="mesh"&&this.geometries.push(a),this.bodies.add(As(c,o.pose)),this.group.add(As(u,o.pose))}this.addSurface(JS.test(e?.task?.surface??"")),this.addGoal(),s.strokes.forEach(r=>{let o=this.keep(new en({linewidth:6,transparent:!0,opacity:.35}),"stroke"),a=di(Er(Tr(s.surface.shape,nh(r,2*Fn),!1),!1),o);this.strokes.push(a),this.strokeGroup.add(a)}),this.group.add(As(this.strokeGroup,s.surface.pose))}round;group=new de;bodies=new de;obstacles=[];sights=null;surface=null;outlines=new Map;strokes=[];strokeGroup=new de;materials=[];geometries=[];show(t,e,n){let{truth:s}=this.round,r=s?.surface??null,{shape:o}=this.round.plan.surface;for(let a of this.outlines.values())a.visible=!1;n&&t.found&&this.showOutline(n,()=>this.outlineAt(n,o,"found",.28)),r&&t.actual&&this.showOutline(r,()=>this.outlineAt(r,Os(s,o),"actual",0)),this.strokeGroup.visible=t.strokes,this.strokes.forEach((a,l)=>{let c=a.material;c.linewidth=l===e?9:6,c.opacity=l===e?.6:.35})}showOutline(t,e){let n=this.outlines.get(t);n||(n=e(),this.outlines.set(t,n),this.group.add(n)),n.visible=!0}fade(t){if(!(!this.surface||!this.obstacles.length)){this.sights??=this.makeSights(this.surface);for(let e of this.obstacles){let[n]=Qc([e]),s=n!==void 0&&this.sights.some(r=>Bd(n,r,t));e.material.transparent=s,e.material.opacity=s?ZS:1,e.material.depthWrite=e.castShadow=!s}}}paint(){for(let t of this.materials)t.color.set(Et(t.name))}dispose(){for(let t of this.materials)t.dispose();for(let t of this.geometries)t.dispose()}keep(t,e){return t.name=e,t.color.set(Et(e)),this.materials.push(t),t}own(t){return this.geometries.push(t),t}get rings(){return this.round.plan.surface.rings.map(t=>nh(t)).filter(t=>t.length>=3)}face(){let t=this.round.plan.surface.shape;if(t?.kind==="mesh")return ia(t).geometry;let[e,...n]=this.rings.map(r=>r.map(([o,a])=>new ht(o,a)));if(!e)return null;let s=new fs(e);return s.holes=n.map(r=>new fs(r)),this.own(Dd(t,new Ao(s)))}makeSights(t){this.group.updateMatrixWorld(!0);let e=Es([t]),n=th(e);return[n,...e.map(s=>s.lerp(n,.1))].map(s=>s.clone().addScaledVector(ji(this.round.plan.surface,s),KS))}addSurface(t){let{pose:e,shape:n}=this.round.plan.surface,s=this.face();if(!s)return;let r=new Mn({side:pn,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1});t&&!n&&(r.map=bg()),this.surface=As(new re(s,this.keep(r,t?"surface-3d":"sheet-3d")),e),this.surface.receiveShadow=!0,this.bodies.add(this.surface);let o=this.rings.flatMap(a=>Er(Tr(n,a,!0),!0));this.group.add(As(di(o,this.keep(new en({linewidth:2}),"outline")),e))}outlineAt(t,e,n,s){let r=As(new de,t),o=this.keep(new en({linewidth:s?3:2}),n),a=this.rings.flatMap(h=>Er(Tr(e,h.map(([u,d,f])=>[u,d,f+(s?1:2)*Fn]),!0),!0)),l=di(s?a:mg(a,[wg*ra[0],wg*ra[1]]),o);this.own(l.geometry),r.add(l);let c=s?this.face():null;if(c){let h=new Mn({transparent:!0,opacity:s,depthWrite:!1});r.add(new re(c,this.keep(h,n)))}return r}addGoal(){let{goal:t,surface:e}=this.round.plan;if(t?.kind!=="collected")return;let[n,s]=t.place,r=As(new de,e.pose),o=(a,l,c)=>{let h=new Mn({transparent:!0,opacity:l,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-3,polygonOffsetUnits:-3});a.translate(n,s,Fn);let u=new re(this.own(Dd(e.shape,a)),this.keep(h,c));r.add(u)};o(new cr(t.radius,48),.22,"goal"),o(new Eo(Math.max(0,t.radius-.003),t.radius,48),1,"goal-line"),o(new cr(Math.min(.006,.3*t.radius),24),1,"goal-line"),this.group.add(r)}};function As(i,t){return i.matrixAutoUpdate=!1,Te(t,i.matrix),i}var fi=({plan:{goal:i}})=>i?.kind==="polished"||i?.kind==="dispensed",Qi=({plan:{goal:i}})=>i?.kind==="dispensed"?"coat thickness":"passes",aa=.51,la={little:"too little",allowed:"allowed",much:"too much"},Gd={little:4,allowed:3,much:2};function Sg(i,t,e,n){let s=n?Math.min(e,t-i):e,r=Array.from({length:s},(o,a)=>i+(t-i)*a/s);return n?r.map(Math.floor):r}function Ar({unit:i,low:t,high:e,target:n}){let s=i==="passes",r=s?e+1:e,o={little:Sg(0,t,Gd.little,s),allowed:Sg(t,r,Gd.allowed,s),much:[r,s?r+Math.max(1,e-t):e+2*(e-n)]},a=(h,u,d)=>1+Math.round(h*(d-1)/Math.max(1,u-1)),l=Object.keys(o).flatMap(h=>o[h].map((u,d,{length:f})=>({degree:h,from:u,colour:`${h}-${a(d,f,Gd[h])}`}))),c=h=>String(s?h:Number(h.toPrecision(h<100?2:3)));return l.map((h,u)=>{let d=l[u+1]?.from,f=d===void 0?null:s?d-1:d;return{...h,label:f===null?`\u2265 ${c(h.from)}`:f===h.from?c(f):`${c(h.from)}\u2013${c(f)}`}})}function Rr(i,{unit:t,target:e},n){let s=t==="passes"?Math.round(n):n,r=1e-6*e,o=0;return i.forEach(({degree:a,from:l},c)=>{(a==="much"&&t!=="passes"?s>l+r:s>=l-r)&&(o=c)}),o}var Tg=({unit:i,low:t,high:e})=>t===e?`${t} ${i}`:`${t} to ${e} ${i}`,Mg=new WeakMap;function oa(i,t){if(!i||!t||t.length!==i.places.length/2)return null;let e=Mg.get(t);if(e)return e;let n=t.map(s=>Je(s)*i.step);return Mg.set(t,n),n}function sh(i,t,e,n){let s=i.endedAt(t);if(s?.plan.treatment){let{interpreted:a,truth:l,plan:{treatment:c,surface:h}}=s,u=a?.found??h.pose,d=`${Qi(s)} after round ${s.number}`,f=n.actual?oa(c,l?.treated):null;if(f)return{kind:"true",title:`True ${d}`,record:c,values:f,pose:l?.surface??u,shape:Os(l,h.shape)};let p=n.estimated?oa(c,a?.treated):null;if(p)return{kind:"estimated",title:`Estimated ${d}: mean of the belief`,record:c,values:p,pose:u,shape:h.shape}}let{treatment:r,surface:o}=e.plan;return!n.believed||!r||!e.treated?null:{kind:"predicted",title:`Predicted ${Qi(e)}`,record:r,values:e.treated.at(t-e.start),pose:o.pose,shape:o.shape}}var rh=["believed","estimated","actual","seen"],Vd={believed:6,estimated:12,actual:8,seen:14},jS=.007,QS={believed:i=>{i.arc(32,32,28,0,2*Math.PI),i.fill()},estimated:i=>{i.lineWidth=9,i.arc(32,32,25,0,2*Math.PI),i.stroke()},actual:i=>{i.lineWidth=15,i.moveTo(10,10),i.lineTo(54,54),i.moveTo(54,10),i.lineTo(10,54),i.stroke()},seen:i=>{i.lineWidth=7,i.rect(6,6,52,52),i.stroke()}};function tM(i){let t=document.createElement("canvas");t.width=t.height=64;let e=t.getContext("2d");return e.fillStyle=e.strokeStyle="#fff",e.beginPath(),QS[i](e),new oi(t)}function eM(i){let t=new Un({size:Vd[i],sizeAttenuation:!1,map:tM(i),alphaTest:.15,transparent:!0});return En(t,.99)}function ah(){let i=document.createElement("canvas");i.width=i.height=64;let t=i.getContext("2d");return t.beginPath(),t.arc(32,32,24,0,2*Math.PI),t.fillStyle="#fff",t.fill(),t.lineWidth=5,t.strokeStyle="#000",t.stroke(),new oi(i)}var oh=class{group=new de;points;shown=new Map;outcome={key:"",outcome:null};constructor(){this.points=Object.fromEntries(rh.map(t=>{let e=new $n(new Ht,eM(t));return e.matrixAutoUpdate=!1,e.frustumCulled=!1,e.renderOrder=2+rh.indexOf(t),this.group.add(e),[t,e]})),this.paint()}paint(){for(let t of rh)this.points[t].material.color.set(Et(t))}show(t,e,{round:n,time:s},r){let o=`${t.version} ${t.rounds.filter(f=>f.end<=e+1e-6).length}`;o!==this.outcome.key&&(this.outcome={key:o,outcome:t.outcomeAt(e)});let{outcome:a}=this.outcome,{pose:l,shape:c}=n.plan.surface,h=!fi(n);this.set("believed",h&&r.believed?n.particles.at(s):null,l,c,1);let u=a?.pose??l,d=t.endedAt(e)||e<n.start+n.firstContact?1:.45;this.set("estimated",h&&r.estimated?a?.estimated??null:null,u,a?.shape,d),this.set("actual",h&&r.actual?a?.actual??null:null,a?.actualPose??u,a?.actualShape,d),this.set("seen",r.seen?a?.seen??null:null,u,a?.shape,d)}scale(t){let e=Math.min(1.25,Math.max(.7,jS*t/Vd.believed));for(let n of rh)this.points[n].material.size=e*Vd[n]}set(t,e,n,s,r){let o=this.points[t];if(o.visible=e!==null&&e.length>0,!e||!o.visible||(Te(n,o.matrix),o.matrixWorldNeedsUpdate=!0,o.material.opacity=r,this.shown.get(t)===e))return;this.shown.set(t,e);let a=e.length/2,l=o.geometry.getAttribute("position");(!l||l.count<a)&&(o.geometry.dispose(),l=new be(new Float32Array(3*Math.max(64,2*a)),3),o.geometry.setAttribute("position",l));for(let c=0;c<a;c++)l.setXYZ(c,...Ji(s,e[2*c],e[2*c+1],Fn));l.needsUpdate=!0,o.geometry.setDrawRange(0,a)}};var Eg=.0015,nM=4e3,iM=.1,sM=11,Ag={none:0,contact:1,pushed:2},Rg=()=>["lifted","contact","pushed"].map(i=>new Ct(Et(i))),lh=class{constructor(t){this.round=t}round;lines=new Kc(3,Rg());times=new Gn(!0);taken=0;step=Eg;last=null;kind=Ag.none;basis="";get object(){return this.lines.line}show(t,e){this.grow();let n=Ni(this.times.data,t,this.times.length)+1;this.lines.show(e?n:0)}paint(){this.lines.paint(Rg())}dispose(){this.lines.dispose()}between(t,e){let n=[],{round:s}=this,r=Math.max(1,Math.floor(s.count/2e4)),o=null;for(let a=Math.max(0,s.place(t)[0]);a<s.count&&s.t.data[a]<=e;a+=r){let l=this.place(a);o&&n.push(...o.toArray(),...l.toArray()),o=l}return n}nearest(t,e,n,s,r){let[o,a]=[r**2,null];for(let l=0;l<this.times.length&&this.times.data[l]<=s;l++){let c=t(this.lines.end(l)),h=(c.x-e)**2+(c.y-n)**2;h<o&&([o,a]=[h,this.times.data[l]])}return a}place(t){let{data:e}=this.round.tool,n=new C(e[7*t],e[7*t+1],e[7*t+2]);return n.addScaledVector(ji(this.round.plan.surface,n),1.5*Fn)}restart(){this.taken=0,this.last=null,this.lines.count=0,this.times.length=0}grow(){let{round:t}=this;this.basis!==t.basis&&this.restart(),this.basis=t.basis;let e=t.over||t.interpreted?t.count:t.count-Kh+1;for(;this.taken<e;){let n=this.taken++,s=t.t.data[n],r=this.place(n);if(!Number.isFinite(r.x+r.y+r.z))continue;let o=Ag[t.contactAt(s)];this.last&&this.last.distanceToSquared(r)<this.step**2&&(o===this.kind||this.step>2*Eg)||(this.last&&(this.lines.push([...this.last.toArray(),...r.toArray()],o),this.times.push(s)),this.last=r,this.kind=o,this.lines.count>nM&&(this.step*=2,this.restart()))}}},ca=["#0072b2","#d55e00","#009e73","#cc79a7","#e69f00","#56b4e9"],ch=class{group=new de;show(t){this.clear(),t.forEach(({points:e,samples:n,color:s},r)=>{let o=new en({linewidth:4.5,transparent:!0,polygonOffset:!0,polygonOffsetFactor:-12,polygonOffsetUnits:-12});o.color.set(uh(s,r));let a=di(Er(e,!1),o);a.renderOrder=6,this.group.add(a),n?.length&&this.group.add(Cg(n,uh(s,r)))})}clear(){Pg(this.group)}},hh=class{group=new de;show(t){Pg(this.group);for(let{pose:e,color:n}of t){let s=Te(e),r=new C().setFromMatrixPosition(s).toArray();for(let[o,a]of["axis-x","axis-y","axis-z"].entries()){let l=new en({linewidth:3.5});l.color.set(Et(a));let c=new C().setComponent(o,iM).applyMatrix4(s).toArray();this.group.add(di([...r,...c],l))}this.group.add(Cg([r],Ii(n,Et("axis-z"))))}}};function Cg(i,t){let e=new Ht().setAttribute("position",new Nt(i.flat(),3)),n=new Un({size:sM,sizeAttenuation:!1,map:ah(),alphaTest:.3,transparent:!0});n.color.set(t);let s=new $n(e,En(n,.98));return s.frustumCulled=!1,s.renderOrder=7,s}function Pg(i){for(let t of[...i.children]){let{geometry:e,material:n}=t;e.dispose(),n.dispose(),i.remove(t)}}var Ii=(i,t)=>i&&/^#[0-9a-f]{3,8}$/i.test(i)?i:t,uh=(i,t)=>Ii(i,ca[t%ca.length]);var ts=400,Rs=220,[Cr,Hd,Wd,ha]=[52,12,10,38],Cs=24,Ps=130;function Ig(i,t){let e=a=>a?.map(([l,c])=>[t(l),c]),n={...i,amounts:e(i.amounts),spans:e(i.spans)},s=n.title||n.id||n.diagram,r=n.amounts?n.diagram==="piechart"?oM(n.amounts):rM(n.amounts):n.spans?aM(n.spans):lM(n);r.setAttribute("role","img"),r.setAttribute("aria-label",`${n.diagram}: ${s}`);let o=[n.x_label,n.y_label].filter(a=>a);return S("figure",{class:"s-plot"},S("figcaption",{},s),r,o.length?S("p",{class:"w-quiet"},o.join(" / ")):null)}var es=i=>Number.isInteger(i)?me(i,0):me(i,Math.abs(i)<10?3:1),ua=(i,...t)=>yt("svg",{viewBox:`0 0 ${ts} ${i}`},...t),An=(i,t,e,n="start")=>yt("text",{x:i,y:t,"text-anchor":n,fill:"var(--ink)","font-size":11.5},e),da=(i,t)=>i.length>t?`${i.slice(0,t-1)}\u2026`:i;function rM(i){let[t,e]=[Math.min(0,...i.map(([,s])=>s)),Math.max(0,...i.map(([,s])=>s))],n=s=>Ps+(ts-Ps-52)*(s-t)/(e-t||1);return ua(i.length*Cs+6,...i.flatMap(([s,r],o)=>{let a=o*Cs+4,[l,c]=r<0?[n(r),n(0)]:[n(0),n(r)];return[An(Ps-6,a+13,da(s,20),"end"),yt("rect",{x:l,y:a,width:Math.max(1,c-l),height:Cs-6,rx:3,fill:"var(--believed)"},yt("title",{},`${s}: ${r}`)),An(c+5,a+13,es(r))]}))}function oM(i){let t=i.reduce((l,[,c])=>l+c,0)||1,[e,n,s]=[90,92,82],r=-Math.PI/2,o=l=>`${e+s*Math.cos(l)} ${n+s*Math.sin(l)}`,a=Math.max(2*n,i.length*20+10);return ua(a,...i.flatMap(([l,c],h)=>{let u=r;r+=2*Math.PI*c/t;let d=ca[h%ca.length];return[c>=t?yt("circle",{cx:e,cy:n,r:s,fill:d}):yt("path",{d:`M${e} ${n}L${o(u)}A${s} ${s} 0 ${r-u>Math.PI?1:0} 1 ${o(r)}Z`,fill:d,stroke:"var(--paper)"}),yt("rect",{x:190,y:h*20+4,width:12,height:12,fill:d}),An(208,h*20+14,`${da(l,20)}: ${es(c)} (${me(100*c/t,0)} %)`)]}))}function aM(i){let t=Math.min(...i.map(([,[r]])=>r)),e=Math.max(...i.map(([,[,r]])=>r)),n=r=>Ps+(ts-Ps-10)*(r-t)/(e-t||1),s=i.length*Cs+22;return ua(s,...i.flatMap(([r,[o,a]],l)=>[An(Ps-6,l*Cs+17,da(r,20),"end"),yt("rect",{x:n(o),y:l*Cs+4,width:Math.max(2,n(a)-n(o)),height:Cs-8,rx:3,fill:"var(--event)"},yt("title",{},`${r}: ${es(a-o)} s`))]),An(Ps,s-4,"0 s"),An(ts-10,s-4,`${es(e-t)} s`,"end"))}function lM({points:i=[],diagram:t,x_label:e,y_label:n}){let s=d=>{let f=i.map(m=>m[d]),[p,x]=[Math.min(...f),Math.max(...f)];return p<x?[p,x]:[p-.5,x+.5]};if(!i.length)return ua(30,An(8,18,"no points"));let[[r,o],[a,l]]=[s(0),s(1)],c=d=>Cr+(ts-Cr-Hd)*(d-r)/(o-r),h=d=>Rs-ha-(Rs-Wd-ha)*(d-a)/(l-a),u=t==="linechart"?[yt("path",{d:i.map(([d,f],p)=>`${p?"L":"M"}${c(d).toFixed(1)} ${h(f).toFixed(1)}`).join(""),fill:"none",stroke:"var(--believed)","stroke-width":1.8})]:i.map(([d,f])=>yt("circle",{cx:c(d),cy:h(f),r:2.6,fill:"var(--believed)","fill-opacity":.7}));return ua(Rs,yt("path",{d:`M${Cr} ${Wd}V${Rs-ha}H${ts-Hd}`,fill:"none",stroke:"var(--rule)"}),...u,An(Cr-5,h(a),es(a),"end"),An(Cr-5,h(l)+9,es(l),"end"),An(Cr,Rs-ha+15,es(r)),An(ts-Hd,Rs-ha+15,es(o),"end"),An(ts/2,Rs-5,da(e,40),"middle"),An(4,Wd+22,da(n,30)))}var cM=.95,$d=.001,hM=([i,t],[e,n])=>i<=n+$d&&t>=e-$d;function ns({about:i,view:t},e){let n=new Map,s=o=>n.set(o,(n.get(o)??0)+1),r=e===null?i:[i[e]??[]];for(let o of r)for(let a of new Set(o.map(({episode:l})=>l)))s(a);if(e===null&&t)for(let{episode:o}of[...t.tracks,...t.bodies,...t.particles])s(o);return[...n].sort((o,a)=>a[1]-o[1]).map(([o])=>o)}function dh(i,t,e,n){let s=i.view,r=s?.episodes.find(h=>h.id===e),o={trajectories:[],ghosts:[],frames:[],intervals:[],particles:[],since:[]};if(!s||!r)return o;let a=h=>fM(n,r.rounds??[r.interval[0]],h),l=dM(t===null?i.about.flat():i.about[t]??[],e,r.interval);for(let{interval:h,class:u}of l)h&&o.intervals.push({start:a(h[0]),end:a(h[1]),label:uM(u)});let c=h=>t===null||!l.length||l.some(u=>u.interval&&hM(u.interval,h));for(let{episode:h,thing:u,interval:d,path:f,samples:p,strong:x,colour:m}of s.tracks){if(h!==e||!c(d))continue;let g=`${qd(u)} ${xe(a(d[0]))} to ${xe(a(d[1]))}`,b=p.map(([,A,y,E])=>[A,y,E]);o.trajectories.push({name:g,points:f.length>1?f:b,samples:b,...Xd(x,m)})}for(let{episode:h,thing:u,kind:d,time:f,pose:p,strong:x,colour:m}of s.bodies)h!==e||!c([f,f])||(d==="robot"||d==="tool"?o.ghosts.push({time:a(f),...Xd(x,m)}):o.frames.push({name:`${qd(u)} at ${xe(a(f))}`,time:a(f),pose:p,...Xd(x,m)}));for(let{episode:h,round:u,state:d,positions:f,colour:p}of s.particles){let x=n.rounds.find(y=>y.number===u),m=r.rounds?.[u-1]??r.interval[0];if(h!==e||!x||!c([m,m+x.length]))continue;let g=d==="before",b=`${g?"dirt before":"estimated dirt after"} round ${u}, as queried`,A=(g?null:x.interpreted?.found)??x.plan.surface.pose;o.particles.push({name:b,state:d,pose:A,shape:x.plan.surface.shape,places:f,...p?{color:p}:{}}),o.since.push(g?x.start:x.end)}if(o.ghosts=[...new Map(o.ghosts.map(h=>[h.time,h])).values()].sort((h,u)=>h.time-u.time),!o.intervals.length)for(let[h,u]of r.shown)o.intervals.push({start:a(h),end:a(u),label:"shown"});return o}var Xd=(i,t)=>t?{color:t}:i?{color:Et("highlight")}:{},uM=i=>i.replace(/([a-z])(?=[A-Z])/g,"$1 ").toLowerCase();function dM(i,t,[e,n]){let s=new Set;return i.filter(({episode:r,interval:o,class:a})=>{if(r!==t||!o)return!1;let l=`${a} ${o.join()}`;return s.has(l)||o[1]-o[0]>cM*(n-e)?!1:(s.add(l),!0)})}function fM(i,t,e){let n=t.findLastIndex(r=>r<=e+$d);n=Math.max(0,n);let s=i.rounds.find(({number:r})=>r===n+1)??i.rounds.at(-1);return s?Math.min(s.end,Math.max(s.start,s.start+e-t[n])):0}function fh(i,{trajectories:t,ghosts:e,frames:n,intervals:s,particles:r,since:o}){i.clearShown(),i.showTrajectories(t),i.showRobotAt(e),i.showFrames(n),i.showParticles(r),i.highlight(s);let a=[[...e,...n].map(({time:l})=>l),s.map(({start:l})=>l),o].find(l=>l.length);a&&i.seek(Math.min(...a))}var qd=i=>i.replace(/^[a-z]+:/,""),Yd=({names:i},t)=>i[t]??qd(t).replace(/_(\d{8}-\d{6}-[0-9a-f]{4})-(\d+)$/," $2"),Zd=({task:i,begun:t})=>`${i}, ${new Date(1e3*t).toLocaleString("en-GB",{day:"numeric",month:"short",hour:"2-digit",minute:"2-digit"})}`;var Kd=200,pM=8,mM=1e9,gM=1e10,Lg={share:["%",100],rad:["\xB0",180/Math.PI],m:["mm",1e3],"m per episode":["mm per episode",1e3]};function fa(i){let{view:t,about:e}=i;return!!t&&ns(i,null).length>0&&(t.tracks.length>0||t.bodies.length>0||t.particles.length>0||e.some(n=>n.some(({interval:s})=>s)))}function ph(i,t){let{rows:e,columns:n,holds:s,more:r,seconds:o,printed:a,remarks:l,view:c,about:h}=i,u=s?`${e.length}${r?" or more":""} ${e.length===1?"answer":"answers"}`:"No answer: false",d=[S("p",{class:"s-count"},S("b",{},u),o===void 0?"":` in ${me(o,2)} s`)];if(fa(i)){d.push(S("div",{class:"s-row"},S("button",{class:"w-button",type:"button",click:()=>t.show(i,null,null)},"Show all"),S("button",{class:"w-button",type:"button",click:()=>t.clear()},"Clear")));let p=ns(i,null);p.length>1&&d.push(S("div",{class:"s-in"},S("span",{class:"w-quiet"},"in "),...p.slice(0,pM).map(x=>S("button",{class:"s-chip",type:"button",title:x,click:()=>t.show(i,null,x)},xM(i,x)))))}let f=c?.left_out??0;f&&d.push(S("p",{class:"w-quiet s-remark"},`The picture is full: ${f} more queried ${f===1?"object is":"objects are"} not drawn.`));for(let p of l)d.push(S("p",{class:"w-quiet s-remark"},p));a&&d.push(S("pre",{class:"s-printed"},a));for(let p of c?.plots??[])d.push(Ig(p,x=>Yd(i,x)));return e.length&&n.length?d.push(vM(i,t)):e.length&&h.every(p=>!p.length)&&d.push(S("p",{},"True.")),e.length>Kd&&d.push(S("p",{class:"w-quiet"},`The table lists the first ${Kd} of ${e.length} answers.`)),d}var xM=({about:i},t)=>{let e=i.flat().find(({episode:n})=>n===t);return e?Zd(e):t};function vM(i,t){let{rows:e,columns:n,units:s,about:r}=i,o=n.map((h,u)=>s[u]?`${h} [${Lg[s[u]]?.[0]??s[u]}]`:h),a=r.some(h=>h.length>0),l=S("tr",{},S("th",{scope:"col"},S("span",{class:"s-hidden"},"show")),...o.map(h=>S("th",{scope:"col"},h)),a&&S("th",{scope:"col"},"Episode")),c=e.slice(0,Kd).map((h,u)=>{let d=r[u]??[];return S("tr",{},S("td",{},d.length?S("button",{class:"w-button s-show",type:"button","data-row":u,"aria-label":`Show answer ${u+1}`,click:()=>t.show(i,u,null)},"Show"):""),...h.map((f,p)=>_M(i,f,s[p]??null)),a&&yM(d))});return S("div",{class:"s-table",tabindex:0,role:"group","aria-label":"Answers"},S("table",{},S("thead",{},l),S("tbody",{},...c)))}function yM(i){let t=new Map(i.map(e=>[e.episode,Zd(e)]));return S("td",{title:[...t.keys()].join(", ")},[...t.values()].join("; "))}function _M(i,t,e){if(typeof t=="number"){let s=!e&&t>=mM&&t<gM,[,r]=Lg[e??""]??["",1],o=s?bM(t):Number.isInteger(t)&&!e?String(t):e==="share"?me(r*t,1):String(Number((r*t).toPrecision(e?3:5)));return S("td",{class:"s-number",title:`${t}${e&&e!=="share"?` ${e}`:""}`},o.replace("-","\u2212"))}if(t===null)return S("td",{class:"w-quiet"},"_");let n=Dg(i,t);return S("td",{title:typeof t=="string"?t:n},n)}var Dg=(i,t)=>t===null?"_":Array.isArray(t)?`[${t.map(e=>Dg(i,e)).join(", ")}]`:typeof t=="number"?String(Number(t.toPrecision(6))):Yd(i,t),bM=i=>{let t=new Date(1e3*i);return`${t.toLocaleTimeString("en-GB")}.${String(t.getMilliseconds()).padStart(3,"0")}`};var Jd=class{constructor(t){this.host=t}host;steps=new Map;draws=new Set;drawn=null;asked=!1;last=0;request(t){return this.steps.set(++this.last,t),this.ask(),this.last}now(){return performance.now()}cancel(t){this.steps.delete(t)}draw(t){this.draws.add(t),this.ask()}drop(t){this.draws.delete(t)}ask(){this.asked||this.drawn||(this.asked=!0,this.host.request(t=>this.run(t)))}run(t){this.asked=!1;let e=this.drawn=new Set,n=this.steps;this.steps=new Map;for(let s of n.values())Ng(()=>s(t));for(let s=this.next(e);s;s=this.next(e))this.draws.delete(s),e.add(s),Ng(s);this.drawn=null,(this.steps.size||this.draws.size)&&this.ask()}next(t){for(let e of this.draws)if(!t.has(e))return e;return null}};function mh(i,t){let e=-1/0,n,s=()=>{n=void 0,e=performance.now(),t()};return{ask:()=>{if(n!==void 0)return;let r=e+i-performance.now();r<=0?s():n=setTimeout(s,r)},stop:()=>clearTimeout(n)}}function Ng(i){try{i()}catch(t){reportError(t)}}var kn=new Jd({request:i=>requestAnimationFrame(i)});var Pr=[.1,.25,.5,1,2,5,10],wM=1.15,jd={least:.12,most:.8},SM=3,Ir=class{constructor(t=kn){this.pictures=t}pictures;time=0;playing=!1;following=!1;speed=1;spans=new Set;callbacks=new Set;frame=null;before=0;late=0;known={edge:0,since:0,every:jd.least,pace:0};join(t){return this.spans.add(t),()=>{this.spans.delete(t)}}get duration(){return Math.max(0,...[...this.spans].map(t=>t.duration))}get end(){return Math.max(0,...[...this.spans].map(t=>t.now))}get edge(){let t=[...this.spans].filter(e=>e.live);return t.length?Math.max(0,...t.map(e=>e.now)):this.end}get isLate(){return this.playing&&this.late>1}get live(){return[...this.spans].some(t=>t.live)}subscribe(t){return this.callbacks.add(t),()=>this.callbacks.delete(t)}onGrowth(){this.following&&!this.live&&(this.following=!1,this.time=this.end),this.following&&(this.keepPace(),this.run()),this.notify()}seek(t){this.following=!1,this.time=Math.min(this.duration,Math.max(0,Number.isFinite(t)?t:0)),this.notify()}play(){if(this.time>=this.end-1e-6){if(this.live)return this.follow();this.time=0}this.playing=!0,this.following=!1,this.run(),this.notify()}pause(){this.playing=!1,this.following=!1,this.notify()}toggle(){this.playing||this.following?this.pause():this.play()}follow(){this.following=!0,this.playing=!1,this.known={edge:-1,since:this.pictures.now(),every:jd.least,pace:0},this.keepPace(),this.run(),this.notify()}setSpeed(t){this.speed=Math.min(10,Math.max(.1,t)),this.notify()}faster(t){let e=Pr.reduce((n,s,r)=>Math.abs(s-this.speed)<Math.abs(Pr[n]-this.speed)?r:n,0);this.setSpeed(Pr[Math.min(Pr.length-1,Math.max(0,e+t))])}destroy(){this.frame!==null&&this.pictures.cancel(this.frame),this.frame=null,this.callbacks.clear()}run(){this.frame===null&&(this.before=this.pictures.now(),this.late=0,this.frame=this.pictures.request(t=>this.step(t)))}step(t){this.frame=null;let e=Math.max(0,(t-this.before)/1e3);this.late=e>SM?this.late+1:0;let n=this.late?.25:e;if(this.before=Math.max(this.before,t),this.following){let{edge:r}=this,o=r-this.time,a=n*this.known.pace;this.time=Math.abs(o)<=Math.max(.001,a)?r:this.time+Math.sign(o)*a}else this.playing&&(this.time=Math.min(this.end,this.time+n*this.speed),this.time>=this.end&&(this.playing=!1,this.live&&this.follow()));(this.playing||this.following&&this.edge!==this.time)&&(this.frame=this.pictures.request(r=>this.step(r))),this.notify()}keepPace(){let{edge:t,known:e}=this;if(t===e.edge)return;let n=this.pictures.now(),{least:s,most:r}=jd,o=Math.min(r,Math.max(s,(n-e.since)/1e3)),a=e.edge<0?s:e.every+.3*(o-e.every);this.known={edge:t,since:n,every:a,pace:Math.abs(t-this.time)/(wM*a)}}notify(){for(let t of this.callbacks)t(this)}};var MM={play:"M4 2.5v11l9.5-5.5z",pause:"M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z",before:"M3 3h2v10H3zM13 3v10L6 8z",after:"M11 3h2v10h-2zM3 3v10l7-5z"},Qd=i=>yt("svg",{viewBox:"0 0 16 16",width:14,height:14,"aria-hidden":"true",fill:"currentColor"},yt("path",{d:MM[i]})),TM={believed:()=>yt("circle",{cx:8,cy:8,r:3.2,fill:"var(--believed)"}),estimated:()=>yt("circle",{cx:8,cy:8,r:4.6,fill:"none",stroke:"var(--estimated)","stroke-width":2.4}),actual:()=>yt("path",{d:"M4 4l8 8M12 4l-8 8",fill:"none",stroke:"var(--actual)","stroke-width":2.6}),seen:()=>yt("rect",{x:3,y:3,width:10,height:10,fill:"none",stroke:"var(--seen)","stroke-width":1.8}),map:()=>yt("g",{},...["little-3","allowed-2","much-1"].map((i,t)=>yt("rect",{x:1+5*t,y:3,width:5,height:10,fill:`var(--${i})`}))),path:()=>yt("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--contact)","stroke-width":2.4}),strokes:()=>yt("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--stroke)","stroke-width":2}),force:()=>yt("path",{d:"M8 15V6M8 1l4 6H4z",fill:"var(--force)",stroke:"var(--force)","stroke-width":2}),events:()=>yt("circle",{cx:8,cy:8,r:4.5,fill:"var(--collision)",stroke:"var(--ink)","stroke-width":1.2}),found:()=>yt("path",{d:"M2 12l3-8h9l-3 8z",fill:"var(--found)","fill-opacity":.3,stroke:"var(--found)","stroke-width":2}),actualSurface:()=>yt("path",{d:"M2 12l3-8h9l-3 8z",fill:"none",stroke:"var(--actual)","stroke-width":1.6,"stroke-dasharray":"3 2"}),collision:()=>yt("path",{d:"M5 2h6l3 6-3 6H5L2 8zM5 2l6 12M11 2L5 14",fill:"none",stroke:"var(--quiet)","stroke-width":1}),"by-touch":()=>yt("path",{d:"M8 1v14M5 1h6M5 15h6",fill:"none",stroke:"var(--by-touch)","stroke-width":1.6}),interval:()=>yt("path",{d:"M8 1v14M4 1h8M4 15h8",fill:"none",stroke:"var(--estimated)","stroke-width":2.2}),target:()=>yt("path",{d:"M0 8h16",fill:"none",stroke:"var(--target)","stroke-width":2,"stroke-dasharray":"4 3"}),goal:()=>yt("circle",{cx:8,cy:8,r:5.5,fill:"var(--goal)","fill-opacity":.35,stroke:"var(--goal-line)","stroke-width":1.6})},pa=i=>yt("svg",{viewBox:"0 0 16 16",width:15,height:15,"aria-hidden":"true"},TM[i]?.()),Ug=(i,t)=>yt("svg",{viewBox:"0 0 16 16",width:15,height:15,"aria-hidden":"true"},yt("path",{d:`M8 1l7 7-7 7-7-7z${t?"M8 5l3 3-3 3-3-3z":""}`,"fill-rule":"evenodd",fill:i,stroke:"#000","stroke-width":1.4}));function EM({mark:i,places:t},e){let n="",s=o=>(1e3*o).toFixed(1),r=e;for(let o=0;o+1<t.length;o+=2){let[a,l]=[1e3*t[o],-1e3*t[o+1]];Number.isFinite(a+l)&&(i==="believed"?n+=`M${a.toFixed(1)} ${l.toFixed(1)}h0`:i==="estimated"?n+=`M${(a-r).toFixed(1)} ${l.toFixed(1)}a${r.toFixed(1)} ${r.toFixed(1)} 0 1 0 ${(2*r).toFixed(1)} 0a${r.toFixed(1)} ${r.toFixed(1)} 0 1 0 ${(-2*r).toFixed(1)} 0`:i==="actual"?n+=`M${(a-r).toFixed(1)} ${(l-r).toFixed(1)}l${(2*r).toFixed(1)} ${(2*r).toFixed(1)}m0 ${(-2*r).toFixed(1)}l${(-2*r).toFixed(1)} ${(2*r).toFixed(1)}`:n+=`M${s(t[o]-r/1e3)} ${s(-t[o+1]-r/1e3)}h${(2*r).toFixed(1)}v${(2*r).toFixed(1)}h${(-2*r).toFixed(1)}z`)}return yt("path",{d:n,class:`w-dots w-dots-${i}`,"stroke-width":i==="believed"?2.2*e:.7*e})}function ma(i,t,e,n=null){let s=i.plan.surface.rings.map(E=>Ve(E)).filter(E=>E.length>=6),{goal:r}=i.plan,[o,a,l,c]=[1/0,1/0,-1/0,-1/0],h=(E,M)=>{[o,l]=[Math.min(o,E),Math.max(l,E)],[a,c]=[Math.min(a,M),Math.max(c,M)]};for(let E of s)for(let M=0;M<E.length;M+=2)h(E[M],E[M+1]);if(r?.kind==="collected"){let[[E,M],v]=[r.place,r.radius];h(E-v,M-v),h(E+v,M+v)}let u=s.length?.15*Math.max(l-o,c-a):1/0,[d,f,p,x]=[o-u,a-u,l+u,c+u];for(let{places:E}of t)for(let M=0;M+1<E.length;M+=2){let[v,T]=[E[M],E[M+1]];(!s.length||v>d&&v<p&&T>f&&T<x)&&h(v,T)}l>o||([o,a,l,c]=[0,0,1,1]);let m=.03*Math.max(l-o,c-a),g=[o-m,-c-m,l-o+2*m,c-a+2*m].map(E=>(1e3*E).toFixed(1)),b=Math.max(1,...t.map(({places:E})=>E.length/2)),A=7*Math.max(l-o,c-a)*Math.min(1,Math.max(.6,Math.sqrt(160/b))),y=s.map(E=>`M${Array.from({length:E.length/2},(M,v)=>`${(1e3*E[2*v]).toFixed(1)} ${(-1e3*E[2*v+1]).toFixed(1)}`).join("L")}Z`).join("");return yt("svg",{viewBox:g.join(" "),class:"w-picture",role:"img","aria-label":e},yt("path",{d:y,class:"w-ground","fill-rule":"evenodd","stroke-width":.005*1e3*Math.max(l-o,c-a)}),n&&yt("clipPath",{id:n.id},yt("path",{d:y,"clip-rule":"evenodd"})),n?.map,r?.kind==="collected"&&yt("circle",{cx:1e3*r.place[0],cy:-1e3*r.place[1],r:1e3*r.radius,class:"w-goal","stroke-width":.004*1e3*Math.max(l-o,c-a)}),...t.map(E=>EM(E,A)))}function tf(i){let t=Ar(i),e=n=>{let s=t.filter(r=>r.degree===n);return s.length>0&&S("li",{"data-degree":n,style:`flex-grow:${s.length}`},S("span",{},la[n]),S("ul",{},...s.map(({label:r,colour:o})=>S("li",{},S("i",{"aria-hidden":"true",style:`background:var(--${o})`}),r))))};return S("div",{class:"w-scale"},S("ul",{"aria-label":`Scale in ${i.unit}`},...Object.keys(la).map(e)),S("p",{},`${i.unit}; allowed: ${Tg(i)}${i.unit==="passes"?", counted in whole passes":`, target ${i.target} ${i.unit}`}`))}function AM(i,t,e){let n={little:0,allowed:0,much:0};for(let s of e)n[t[Rr(t,i,s)].degree]++;return Object.keys(la).map(s=>`${(100*n[s]/Math.max(1,e.length)).toFixed(1)}\u202F% ${la[s]}`).join(", ")}function RM(i,t){let e=Ar(i),n=e.map(()=>""),s=Ve(i.places),[r,o]=i.cell.map(h=>1e3*h),[a,l]=[aa*r,aa*o],c=t.length;for(let h=0;h<c;){let u=Rr(e,i,t[h]),[d,f]=[1e3*s[2*h],-1e3*s[2*h+1]],p=1,x=m=>h+m<c&&Math.abs(-1e3*s[2*(h+m)+1]-f)<.1*o&&Math.abs(1e3*s[2*(h+m)]-d-m*r)<.1*r;for(;x(p)&&Rr(e,i,t[h+p])===u;)p++;n[u]+=`M${(d-a).toFixed(1)} ${(f-l).toFixed(1)}H${(d+(p-1)*r+a).toFixed(1)}V${(f+l).toFixed(1)}H${(d-a).toFixed(1)}z`,h+=p}return e.map(({colour:h},u)=>yt("path",{d:n[u],style:`fill:var(--${h})`}))}function Og({rounds:i}){let t=i[0],e=i.at(-1),n=i.findLast(u=>u.interpreted??u.truth)??null,s=t.plan.surface.shape?", surface unrolled":"",r=e.plan.treatment;if(!r){let u=`This recording has no ${Qi(e)} per place.`;return[S("figure",{class:"w-wide"},ma(e,[],u),S("figcaption",{},u))]}let o=(u,d,f)=>{let p=d.plan.treatment;if(!p||!f)return null;let x=Aa(),m=`${u}: ${Qi(d)} per place; ${AM(p,Ar(p),f)} of ${f.length} places`,g=yt("g",{"clip-path":`url(#${x})`,class:"w-map"},...RM(p,f));return S("figure",{},ma(d,[],m,{id:x,map:g}),S("figcaption",{},u))},a=n&&`after ${n.number} ${n.number===1?"round":"rounds"}`,l=[o("Before",t,t.treated?.first??null),o(e.number===1?"Predicted":`Predicted for round ${e.number}`,e,e.treated?.last??null),n&&o(`Estimated ${a}: mean of the belief`,n,oa(n.plan.treatment,n.interpreted?.treated)),n&&o(`True ${a}`,n,oa(n.plan.treatment,n.truth?.treated))].filter(u=>u!==null),c=Qi(e),h=`${Ta(c)} per place${s}`;return[S("p",{class:"w-wide w-quiet"},h),...l,tf(r)]}function CM(i){let{phases:t,growth:e,strokes:n}=i.plan;if(!e.length)return[];let s=0,r=i.growthAt(0);return t.filter(({stroke:o})=>o!==null).map(({end:o,stroke:a})=>{let l=i.growthAt(o),c={stroke:a,gain:l-r,way:PM(Ve(n[a]??[])),time:o-s};return[s,r]=[o,l],c})}var PM=i=>{let t=0;for(let e=2;e+1<i.length;e+=2)t+=Math.hypot(i[e]-i[e-2],i[e+1]-i[e-1]);return t};function Fg(i,t){let e=CM(i);if(!e.length)return null;let n=i.start;return S("div",{class:"w-choice",tabindex:0,role:"group","aria-label":"Strokes"},S("table",{},S("caption",{},"Predicted gain of each stroke in performance, with its way in contact and its time, including the way to it. A stroke without a gain may prepare a later one."),S("thead",{},S("tr",{},...["Stroke","Gain","Contact","Time"].map(s=>S("th",{scope:"col"},s)))),S("tbody",{},...e.map(({stroke:s,gain:r,way:o,time:a})=>{let l=n+=a;return S("tr",{},S("th",{scope:"row"},S("button",{type:"button",class:"w-link",click:()=>t(l)},String(s+1))),...[`${r>0?"+":""}${Yt(r)}`,`${me(o,2)} m`,`${me(a,1)} s`].map(c=>S("td",{},c)))}))))}var ga=(i,t,...e)=>S("details",{class:"w-section",open:t},S("summary",{},S("h2",{},i)),...e),kg=i=>S("ul",{class:"w-sentences"},...i.map(t=>S("li",{},String(t)))),Is=({mean:i,low:t,high:e},n=Yt(i))=>`${n} (90\u202F%: ${Yt(t)} to ${Yt(e)})`,IM=["performance unknown","undecided by touch","cannot be told","unknowable by touch"],nf=(i,t)=>i?"met":IM.includes(t??"")?"unknown":"unmet";function Dr({rounds:i,ended:t,live:e}){let n=r=>i.length>0&&i.every(({plan:o})=>o.kind===r);return e?{state:"live",text:"running"}:n("planned")?{state:"planned",text:"planned only"}:n("logged")?{state:"logged",text:"from the log"}:t?{state:nf(t.met,t.verdict),text:t.badge??t.verdict??(t.met?"goal met":"stopped")}:{state:"broken",text:"ended early"}}function gh({rounds:i,ended:t},{number:e,plan:{kind:n},interpreted:s,over:r}){return n==="planned"?"planned only":n==="logged"?"from the log":s?(i.findLast(a=>a.interpreted)?.number===e?t?.badge:null)??s.verdict:r?"no result":"running"}var Lr=(i,t)=>[S("dt",{},i),S("dd",{},t)],Bn="\u2013",gn=(i,t)=>typeof i=="number"?t(i):Bn;function LM(i){let t=[...i].sort((s,r)=>(r.score??-1/0)-(s.score??-1/0)),e=["Strategy","Score","Share","Lost","Contact","Time"],n=s=>[gn(s.score,r=>me(r,2)),gn(s.predicted,Yt),gn(s.lost,Yt),gn(s.in_contact,r=>`${me(r,2)} m`),gn(s.duration,r=>`${me(r,0)} s`)];return S("div",{class:"w-choice",tabindex:0,role:"group","aria-label":"Candidate plans"},S("table",{},S("caption",{},"Share: predicted performance. Lost: predicted share of lost dirt. Score: predicted share of the dirt that reaches the goal, minus three times the lost share, minus what heaps near an edge put at risk, minus costs of remaining dirt by its distance, of path length and time."),S("thead",{},S("tr",{},...e.map(s=>S("th",{scope:"col"},s)))),S("tbody",{},...t.map(s=>S("tr",{"data-chosen":s.chosen,title:s.strokes===null?null:`${s.strokes} strokes`},S("th",{scope:"row"},`${s.chosen?"\u2713 ":""}${s.strategy}`,s.chosen&&S("span",{class:"w-hidden"}," (chosen)")),...s.error===null||s.error===void 0?n(s).map(r=>S("td",{},r)):[S("td",{class:"w-none-found",colspan:e.length-1},`no plan: ${s.error}`)])))))}var xh="The episode was kept without a recording: the page shows its telemetry and its events.",ef=300,vh=class{constructor(t,e){this.recording=t;this.clock=e;let{contact:n,force:s,height:r,performance:o}=this.live;this.element=S("aside",{class:"w-words","aria-label":"Details of the run",tabindex:0},S("div",{class:"w-now"},this.headline,this.below,S("dl",{class:"w-values"},S("div",{},S("dt",{},"Contact"),n),S("div",{},S("dt",{},"Force"),s),S("div",{},S("dt",{},"Height"),r),S("div",{},this.performanceName,o))),this.complaint,ga("Why this plan",!0,this.why),ga("Result",!0,this.after),ga("Events",!0,this.events),ga("Numbers",!0,this.numbers),ga("Log",!1,this.logCount,this.log))}recording;clock;element;headline=S("p",{class:"w-headline"});below=S("p",{class:"w-quiet"});live={contact:S("dd"),force:S("dd"),height:S("dd"),performance:S("dd")};performanceName=S("dt",{},"Predicted");why=S("div");after=S("div");events=S("div");numbers=S("div");log=S("ol",{class:"w-log"});logCount=S("span",{class:"w-quiet"});complaint=S("p",{class:"w-complaint",hidden:!0});key="";whole="";shownEvents=[];show(){let{recording:t,clock:e}=this,n=t.at(e.time);this.showNow(n);let s=n?.round,r=[s?.number,s?.start,t.rounds.length,!!s?.interpreted,!!s?.truth,t.live,t.ended?.badge].join();r!==this.key&&(this.key=r,this.showRound(s??null));let{stages:o,happenings:a,head:l,ended:c,broken:h,unknown:u}=t,d=[o.length,a.length,!!l,!!c,h,u].join();d!==this.whole&&(this.whole=d,this.showRun());for(let{element:f,start:p,end:x}of this.shownEvents)f.toggleAttribute("data-now",e.time>=p-.05&&e.time<=x+.05)}showNow(t){let{recording:e,clock:n}=this,s=e.live&&(n.following||!t)?e.stages.at(-1):void 0;if(!t){$t(this.headline,s?.words??(e.live?e.head?"No round has begun.":"The recording is empty so far.":"The recording has no rounds.")),$t(this.below,"");for(let g of Object.values(this.live))$t(g,Bn);return}let{round:r,time:o,normal:a,height:l,performance:c,contact:h}=t,u=r.plan.phases[t.phase],d=e.rounds.length,f=o>=r.length-1e-6&&r.interpreted,p=f?gh(e,r):u?Ea(u.name):"starting",x=!f&&u?.stroke!==null&&u?.stroke!==void 0?` \xB7 stroke ${u.stroke+1} of ${r.plan.strokes.length}`:"";$t(this.headline,Ta(s&&s.stage!=="executing"?s.words:`${p}${x}`)),$t(this.below,`Round ${r.number} of ${d}${r.plan.kind==="planned"?" (planned only)":""} \xB7 ${xe(o)} of ${xe(r.length)}`),$t(this.live.contact,h==="contact"?"yes":h==="pushed"?"pushed":"none"),$t(this.live.force,gn(a,g=>`${me(g,1)} N`)),$t(this.live.height,gn(l,g=>`${me(1e3*g,1)} mm`));let m=e.resultAt(n.time)?.interpreted;$t(this.performanceName,m?"Estimated":"Predicted"),$t(this.live.performance,m?Yt(m.estimate.mean):gn(c,Yt))}showRound(t){let e=t?.plan.why??[],n=t?.plan.considered??[];if(this.why.replaceChildren(e.length?kg(e):S("p",{class:"w-quiet"},t?t.plan.kind==="logged"?xh:"The recording states no reasons for this plan.":"No plan yet."),...n.length?[LM(n)]:[],(t&&Fg(t,o=>this.clock.seek(o)))??""),!t?.interpreted){let o=t?t.plan.kind==="planned"?"This plan was not executed.":t.plan.kind==="logged"?xh:this.recording.live?"The round is not finished.":"The round has no result because the run ended early.":"No round yet.";this.after.replaceChildren(S("p",{class:"w-quiet"},o));return}let{interpreted:s,truth:r}=t;this.after.replaceChildren(S("p",{class:"w-quiet"},`Round ${t.number}, known from ${xe(t.end)} on.`),S("p",{},S("strong",{},gh(this.recording,t)),s.ending?` \xB7 ${s.ending}`:""),S("dl",{class:"w-facts"},...Lr("Predicted",gn(t.plan.predicted,Yt)),...Lr("Estimated",Is(s.estimate)),...Lr("From touch only",Is(s.by_touch)),...typeof r?.performance=="number"?Lr("True",Yt(r.performance)):[],...s.found?Lr("Surface","not at its believed pose"):[]),kg(s.words))}showRun(){let{recording:t,clock:e}=this,n=t.happenings.slice(0,ef);this.shownEvents=[],this.events.replaceChildren(n.length?S("ul",{class:"w-events"},...n.map(({start:o,end:a,kind:l,words:c,source:h})=>{let u=S("button",{type:"button","data-source":h,click:()=>e.seek(o)},S("span",{class:"w-when"},xe(o)),S("span",{},S("strong",{},l),` ${c}`));return this.shownEvents.push({element:u,start:o,end:a}),S("li",{},u)}),t.happenings.length>ef&&S("li",{class:"w-quiet"},`and ${t.happenings.length-ef} more`)):S("p",{class:"w-quiet"},"None.")),this.showNumbers(),this.log.replaceChildren(...t.stages.slice(-500).map(({round:o,stage:a,words:l})=>S("li",{},S("span",{class:"w-when"},`${o} ${a}`),` ${l}`))),$t(this.logCount,t.stages.length>500?`The list shows the last 500 of ${t.stages.length} entries.`:"");let{broken:s,unknown:r}=t;this.complaint.hidden=!s&&!r,$t(this.complaint,[s?`${s} ${s===1?"line":"lines"} of this recording could not be read.`:"",r?`${r} ${r===1?"piece":"pieces"} of unknown kind ${r===1?"was":"were"} skipped.`:""].join(" ").trim())}showNumbers(){let{head:t,ended:e,rounds:n}=this.recording;if(!t)return;let{task:s,robot:r}=t,o=[...s?[["Task",`${s.action} ${s.medium} with ${s.tool} on ${s.surface}`],["Strategy",s.strategy],["Target",Yt(s.target)],["Seed",String(s.seed)]]:[],...r?[["Robot",`${r.name}, ${r.variables.length} variables`]]:[],["Program",t.program],...t.begun?[["Started",t.begun]]:[],...e?.episode?[["Episode",e.episode]]:[]],a=new Set(o.map(([c])=>c)),l=new Map([[null,o]]);for(let c of e?.facts??[]){if(a.has(c[0]))continue;let h=n.length>1?DM(c,n[0].number):null;l.set(h,[...l.get(h)??[],[c[0],c[1]]])}this.numbers.replaceChildren(...[...l].flatMap(([c,h])=>[...l.size>1?[S("h3",{},c===null?`Whole run, ${n.length} rounds`:`Round ${c}`)]:[],S("dl",{class:"w-facts"},...h.flatMap(([u,d])=>Lr(String(u),String(d))))]))}},DM=([i,t,e],n)=>e!==void 0?e:/ in \d+ rounds$/.test(t)||/^(Target performance|Tool held|Maximum path error|Minimum clearance|Distance in contact|Distance in total|Goal|Steps|Links|Joints held at their ready positions)$/.test(i)?null:n;var sf={believed:"believed before",estimated:"estimated after",actual:"true after",seen:"observed",interval:"90\u202F% interval","by-touch":"from touch only",target:"target",goal:"goal area"},yh=i=>S("ul",{class:"w-legend"},...i.map(t=>S("li",{},pa(t),sf[t]))),NM=6;function UM(i){let t=S("button",{type:"button",class:"w-button",click:()=>{(navigator.clipboard?navigator.clipboard.writeText(i):Promise.reject()).then(()=>$t(t,"Copied"),()=>$t(t,"Not copied"))}},"Copy");return S("div",{class:"w-command"},S("code",{},i),t)}var Nr=class{constructor(t,e,n){this.recording=t;this.seek=e;this.element=S("header",{class:"w-story"},S("div",{class:"w-top"},this.title,this.badge,n),S("div",{class:"w-told"},this.pictures,this.texts),this.incidents),this.stop=t.onChange(s=>{(!s||s.piece!=="samples")&&this.ask()}),this.show()}recording;seek;element;title=S("h1",{});badge=S("p",{class:"w-badge"});pictures=S("div",{class:"w-pictures"});texts=S("div",{class:"w-texts"});incidents=S("section",{class:"w-incidents","aria-label":"Incidents"});keys=new Map;stop;asked=0;destroy(){this.stop(),cancelAnimationFrame(this.asked)}ask(){this.asked||(this.asked=requestAnimationFrame(()=>{this.asked=0,this.show()}))}show(){let{head:t,ended:e,rounds:n,stages:s,live:r}=this.recording,o=n.findLast(p=>p.interpreted)??null;$t(this.title,t?.title||"Recording");let{state:a,text:l}=Dr(this.recording),[c,h]=[a==="planned",a==="logged"];this.badge.dataset.state=a,$t(this.badge,l);let u=e?.story,d=u?.happened??(r?s.at(-1)?.words??"The run is starting.":o?`The run ended early after round ${o.number}: ${o.interpreted.verdict}.`:c?`Planned, not executed. Predicted performance: ${Yt(n.at(-1).plan.predicted??0)}.`:h?xh:n.length?"The recording ends before the first round has a result.":"The recording has no rounds."),f=n.map(({number:p,interpreted:x,truth:m})=>[p,x?.estimate,x?.by_touch,m?.performance]);this.rebuild(this.texts,[t?.task,u,r,d,a,f],()=>[...this.makePart("Task",u?.asked??t?.task?.asked??""),...this.makePart(r?"Now":"Result",d),...this.makePart("Confidence",u?.sure??(o||c||h?"":"No round has a result yet."),this.drawBars()),...this.makePart("More certainty",u?.surer??""),...this.makePart("Next",u?.next?.words??"",u?.next?.command?UM(u.next.command):null)]),this.drawPictures(),this.showIncidents()}showIncidents(){let t=this.recording.rounds.flatMap(o=>(o.interpreted?.incidents??[]).map(a=>({round:o,incident:a}))),e=this.recording.rounds.some(o=>o.interpreted?.incidents),n=t.slice(0,NM),s=t.length-n.length;this.incidents.hidden=!e;let r=[s,n.map(({round:{number:o,start:a},incident:l})=>[o,a,l])];this.rebuild(this.incidents,r,()=>[S("h2",{},"What did not go as planned"),...t.length?[S("ul",{},...n.map(({round:o,incident:a})=>this.makeCard(o,a))),...s?[S("p",{class:"w-quiet"},`and ${s} more`)]:[]]:[S("p",{class:"w-quiet"},"Nothing unusual was detected.")]])}rebuild(t,e,n){let s=JSON.stringify(e);this.keys.get(t)!==s&&(this.keys.set(t,s),t.replaceChildren(...n()))}makeCard(t,{time:e,title:n,evidence:s,effect:r,advice:o}){let a=`Round ${t.number}${e===null?"":` \xB7 ${xe(t.start+e)}`}`;return S("li",{"data-round":t.number},S("button",{type:"button",class:"w-when",title:"Show this time",click:()=>this.seek(t.start+(e??0))},a),S("h3",{},n),...[s,r].filter(l=>l).map(l=>S("p",{},l)),o?S("p",{class:"w-advice"},o):null)}makePart(t,e,n=null){if(!e&&!n)return[];let s=[S("h2",{},t)];return e&&s.push(S("p",{},e)),n&&s.push(n),s}drawPictures(){let{rounds:t,observedBefore:e}=this.recording,n=t[0];if(!n){this.pictures.replaceChildren();return}if(this.pictures.toggleAttribute("data-maps",fi(n)),fi(n)){this.pictures.replaceChildren(...Og(this.recording));return}let s=n.plan.goal?.kind==="collected"?["goal"]:[],r=t.findLast(u=>u.interpreted??u.truth)??null,o=[{mark:"believed",places:n.particles.places(0)}];e&&o.push({mark:"seen",places:Ve(e.detections)});let a=[];r?.interpreted&&a.push({mark:"estimated",places:Ve(r.interpreted.particles)}),r?.truth?.particles&&a.push({mark:"actual",places:Ve(r.truth.particles)}),r?.observed&&a.push({mark:"seen",places:Ve(r.observed.detections)});let l=n.plan.surface.shape,c=(u,d,f)=>S("figure",{},ma(d,f,`${u}: the ${l?"unrolled surface":"surface from above"} with ${f.map(({places:p,mark:x})=>`${p.length/2} particles ${sf[x]}`).join(", ")}`),S("figcaption",{},l?`${u}, surface unrolled`:u));if(!r){let u=n.particles.places(Math.max(0,n.particles.times.length-1));n.plan.kind==="planned"?this.pictures.replaceChildren(c("Before",n,o),this.drawArrow(),c("Predicted",n,[{mark:"believed",places:u}]),yh(["believed",...s])):this.pictures.replaceChildren(c("Believed before",n,o),yh([...o.map(({mark:d})=>d),...s]));return}let h=[...new Set([...o,...a].map(({mark:u})=>u)),...s];this.pictures.replaceChildren(c("Before",n,o),this.drawArrow(),c(`After ${r.number} ${r.number===1?"round":"rounds"}`,r,a),yh(h))}drawArrow(){return yt("svg",{viewBox:"0 0 24 24",class:"w-arrow","aria-hidden":"true"},yt("path",{d:"M3 12h16M13 6l6 6-6 6"}))}drawBars(){let{rounds:t,head:e}=this.recording,n=t.filter(l=>l.interpreted).slice(-8);if(!n.length)return null;let s=e?.task?.target??null,r=n.map(({number:l,interpreted:c,truth:h})=>{let{estimate:u,by_touch:d}=c,f=h?.performance??null,p=b=>`${(1.5+97*Math.min(1,Math.max(0,b))).toFixed(2)}%`,x=(b,A)=>`${Math.max(.6,97*(Math.min(1,A)-Math.max(0,b))).toFixed(2)}%`,m=(b,A,y,E)=>yt("line",{x1:p(b),x2:p(b),y1:A,y2:y,...E}),g=`Round ${l}: estimated ${Yt(u.mean)}, 90 % interval ${Yt(u.low)} to ${Yt(u.high)}${f===null?"":`, true ${Yt(f)}`}`;return S("div",{class:"w-bar"},S("span",{},`Round ${l}`),yt("svg",{role:"img","aria-label":g},yt("rect",{x:p(0),y:8,width:"97%",height:10,rx:5,fill:"var(--lane)"}),yt("rect",{x:p(d.low),y:21.5,width:x(d.low,d.high),height:2,fill:"var(--by-touch)"}),yt("rect",{x:p(u.low),y:6,width:x(u.low,u.high),height:14,rx:4,fill:"var(--estimated)","fill-opacity":.35,stroke:"var(--estimated)","stroke-width":1.6}),m(u.mean,4,22,{stroke:"var(--estimated)","stroke-width":3}),s!==null&&m(s,0,26,{stroke:"var(--target)","stroke-width":2,"stroke-dasharray":"4 3"}),f!==null&&yt("svg",{x:p(f),y:13,overflow:"visible"},yt("path",{d:"M-5 -5L5 5M5 -5L-5 5",stroke:"var(--actual)","stroke-width":2.6,fill:"none"}))),S("b",{},Yt(u.mean)))}),o=n.some(({truth:l})=>typeof l?.performance=="number"),a=yh(["interval","by-touch",...o?["actual"]:[],...s===null?[]:["target"]]);for(let l of a.children)l.textContent===sf.actual&&(l.lastChild.textContent="true");return s!==null&&(a.lastElementChild.lastChild.textContent=`target ${Yt(s)}`),S("div",{class:"w-bars"},...r,a)}};var Bg=[["Space","play, pause"],["\u2190 \u2192","0.1 s back, forward (with Shift: 1 s)"],["[ ]","previous, next event or stroke"],["Home End","start, end"],["+ \u2212","faster, slower"],["L","follow a live run"],["F","fit view"],["T","follow the work: wide in free motion, close at strokes"],["V","view from above"],["W A S D","turn the scene (while it has the focus)"],["Z X","zoom in, out (while the scene has the focus)"]];function bh(i,t,e){return(e>0?i.find(s=>s>t+.05):i.findLast(s=>s<t-.05))??(e>0?i.at(-1)??t:i[0]??t)}var _h=[],OM=(i,t)=>i instanceof HTMLElement?i.isContentEditable||/^(TEXTAREA|SELECT)$/.test(i.tagName)?!0:i instanceof HTMLInputElement&&i.type==="range"?/^(Arrow|Page|Home$|End$)/.test(t):i instanceof HTMLInputElement?!(i.type==="checkbox"&&t!==" "):t===" "&&/^(BUTTON|A|SUMMARY)$/.test(i.tagName):!1;function zg(i,t,e,n){_h.push(i);let s=a=>{t.playing&&t.pause(),t.seek(t.time+a)},r={" ":()=>t.toggle(),ArrowLeft:a=>s(a?-1:-.1),ArrowRight:a=>s(a?1:.1),"[":()=>t.seek(bh(e.stops,t.time,-1)),"]":()=>t.seek(bh(e.stops,t.time,1)),Home:()=>t.seek(0),End:()=>t.seek(t.end),"+":()=>t.faster(1),"=":()=>t.faster(1),"-":()=>t.faster(-1)},o=a=>{if(a.ctrlKey||a.metaKey||a.altKey||a.defaultPrevented||OM(a.target,a.key))return;let l=a.target,c=l===document.body||l===document.documentElement;if(!i.contains(l)&&!(c&&_h[0]===i))return;let h=r[a.key];if(h)h(a.shiftKey);else if(!n(a.key.toLowerCase()))return;a.preventDefault()};return document.addEventListener("keydown",o),()=>{document.removeEventListener("keydown",o),_h.splice(_h.indexOf(i),1)}}var FM=13;function Gg(i){let t=document.createElement("canvas");t.width=t.height=64;let e=t.getContext("2d"),n=s=>{e.beginPath(),e.moveTo(32,32-s),e.lineTo(32+s,32),e.lineTo(32,32+s),e.lineTo(32-s,32),e.closePath()};return e.fillStyle="#000",n(31),e.fill(),e.fillStyle="#fff",n(24),e.fill(),i&&(e.globalCompositeOperation="destination-out",n(13),e.fill()),new oi(t)}var wh=i=>Ii(i,Et("highlight")),Sh=class{group=new de;textures={before:Gg(!1),estimated:Gg(!0)};list=[];show(t){this.list=t;for(let e of this.points)e.geometry.dispose(),e.material.dispose();this.group.clear(),t.forEach(({color:e,pose:n,shape:s,places:r,state:o},a)=>{let l=new Ht;l.setAttribute("position",new Nt(r.flatMap(([u,d])=>Ji(s,u,d,2*Fn)),3));let c=new Un({size:FM,sizeAttenuation:!1,map:this.textures[o],alphaTest:.3,transparent:!0});c.color.set(wh(e));let h=new $n(l,En(c,.98));h.matrixAutoUpdate=!1,Te(n,h.matrix),h.frustumCulled=!1,h.renderOrder=7+a/(t.length+1),this.group.add(h)})}paint(){this.points.forEach(({material:t},e)=>t.color.set(wh(this.list[e].color)))}get points(){return this.group.children}};var Vg={type:"change"},of={type:"start"},Wg={type:"end"},Mh=new si,Hg=new bn,kM=Math.cos(70*yr.DEG2RAD),De=new C,xn=2*Math.PI,oe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},rf=1e-6,Th=class extends Vo{constructor(t,e=null){super(t,e),this.state=oe.NONE,this.target=new C,this.cursor=new C,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:qi.ROTATE,MIDDLE:qi.DOLLY,RIGHT:qi.PAN},this.touches={ONE:Yi.ROTATE,TWO:Yi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new C,this._lastQuaternion=new an,this._lastTargetPosition=new C,this._quat=new an().setFromUnitVectors(t.up,new C(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new pr,this._sphericalDelta=new pr,this._scale=1,this._panOffset=new C,this._rotateStart=new ht,this._rotateEnd=new ht,this._rotateDelta=new ht,this._panStart=new ht,this._panEnd=new ht,this._panDelta=new ht,this._dollyStart=new ht,this._dollyEnd=new ht,this._dollyDelta=new ht,this._dollyDirection=new C,this._mouse=new ht,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=zM.bind(this),this._onPointerDown=BM.bind(this),this._onPointerUp=GM.bind(this),this._onContextMenu=YM.bind(this),this._onMouseWheel=WM.bind(this),this._onKeyDown=XM.bind(this),this._onTouchStart=$M.bind(this),this._onTouchMove=qM.bind(this),this._onMouseDown=VM.bind(this),this._onMouseMove=HM.bind(this),this._interceptControlDown=ZM.bind(this),this._interceptControlUp=KM.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=oe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Vg),this.update(),this.state=oe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;De.copy(e).sub(this.target),De.applyQuaternion(this._quat),this._spherical.setFromVector3(De),this.autoRotate&&this.state===oe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=xn:n>Math.PI&&(n-=xn),s<-Math.PI?s+=xn:s>Math.PI&&(s-=xn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(De.setFromSpherical(this._spherical),De.applyQuaternion(this._quatInverse),e.copy(this.target).add(De),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=De.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new C(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new C(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=De.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Mh.origin.copy(this.object.position),Mh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Mh.direction))<kM?this.object.lookAt(this.target):(Hg.setFromNormalAndCoplanarPoint(this.object.up,this.target),Mh.intersectPlane(Hg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>rf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>rf||this._lastTargetPosition.distanceToSquared(this.target)>rf?(this.dispatchEvent(Vg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?xn/60*this.autoRotateSpeed*t:xn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){De.setFromMatrixColumn(e,0),De.multiplyScalar(-t),this._panOffset.add(De)}_panUp(t,e){this.screenSpacePanning===!0?De.setFromMatrixColumn(e,1):(De.setFromMatrixColumn(e,0),De.crossVectors(this.object.up,De)),De.multiplyScalar(t),this._panOffset.add(De)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;De.copy(s).sub(this.target);let r=De.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(xn*this._rotateDelta.x/e.clientHeight),this._rotateUp(xn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(xn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-xn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(xn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-xn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(xn*this._rotateDelta.x/e.clientHeight),this._rotateUp(xn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new ht,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function BM(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function zM(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function GM(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Wg),this.state=oe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function VM(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case qi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=oe.DOLLY;break;case qi.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=oe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=oe.ROTATE}break;case qi.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=oe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=oe.PAN}break;default:this.state=oe.NONE}this.state!==oe.NONE&&this.dispatchEvent(of)}function HM(i){switch(this.state){case oe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case oe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case oe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function WM(i){this.enabled===!1||this.enableZoom===!1||this.state!==oe.NONE||(i.preventDefault(),this.dispatchEvent(of),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Wg))}function XM(i){this.enabled!==!1&&this._handleKeyDown(i)}function $M(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Yi.ROTATE:if(this.enableRotate===!1){this.state=oe.NONE;break}this._handleTouchStartRotate(i),this.state=oe.TOUCH_ROTATE;break;case Yi.PAN:if(this.enablePan===!1){this.state=oe.NONE;break}this._handleTouchStartPan(i),this.state=oe.TOUCH_PAN;break;default:this.state=oe.NONE}break;case 2:switch(this.touches.TWO){case Yi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=oe.TOUCH_DOLLY_PAN;break;case Yi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=oe.TOUCH_DOLLY_ROTATE;break;default:this.state=oe.NONE}break;default:this.state=oe.NONE}this.state!==oe.NONE&&this.dispatchEvent(of)}function qM(i){switch(this._trackPointer(i),this.state){case oe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case oe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case oe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case oe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=oe.NONE}}function YM(i){this.enabled!==!1&&i.preventDefault()}function ZM(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function KM(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Eh=Math.PI/24,JM=380,Ah=class{constructor(t,e,n){this.taken=n;this.lens.up.set(0,0,1),this.controls=new Th(this.lens,t),this.controls.maxPolarAngle=.62*Math.PI,this.controls.minDistance=.1,this.controls.maxDistance=40,this.controls.zoomToCursor=!0,this.controls.addEventListener("start",()=>{this.held=!0}),this.controls.addEventListener("end",()=>{this.held=!1}),this.controls.addEventListener("change",()=>{this.held&&this.take(),e()}),t.addEventListener("wheel",s=>{let{scrollHeight:r,clientHeight:o}=document.documentElement;this.controls.enableZoom=s.ctrlKey||document.activeElement===t||r<=o+1},{capture:!0,passive:!0}),t.addEventListener("pointerdown",()=>{this.controls.enableZoom=!0,t.focus({preventScroll:!0})},!0),t.addEventListener("keydown",s=>{if(s.ctrlKey||s.metaKey||s.altKey)return;let r={a:[-Eh,0],d:[Eh,0],w:[0,-Eh],s:[0,Eh]},o={z:1/1.15,x:1.15},[a,l]=[r[s.key],o[s.key]];if(a)this.turn(...a);else if(l)this.zoom(l);else return;s.preventDefault(),s.stopPropagation()})}taken;lens=new rn(36,1,.02,200);controls;open=1;goal=null;stepped=0;asked=!1;held=!1;get angles(){let t=Math.tan(this.lens.fov*Math.PI/360);return{high:t,wide:t*this.lens.aspect*this.open}}look(t,e=!1){if(t){if(this.goal=e&&!matchMedia("(prefers-reduced-motion: reduce)").matches?t:null,this.stepped=performance.now(),this.asked=e,!this.goal)return this.move(t);this.controls.dispatchEvent({type:"change"})}}step(){if(!this.goal)return!1;let t=performance.now(),e=1-Math.exp((this.stepped-t)/JM);this.stepped=t;let{goal:n}=this,s=this.controls.target.clone().lerp(n.target,e),r=this.lens.position.clone().lerp(n.eye,e);return r.distanceTo(n.eye)+s.distanceTo(n.target)<.002*r.distanceTo(s)&&(this.goal=null),this.move(this.goal?{target:s,eye:r}:n),this.goal!==null}followLinked(t,e){e&&this.take(),this.goal=null,this.move(t)}get view(){return{target:this.controls.target.clone(),eye:this.lens.position.clone()}}pixelsPerMetre(t,e){let n=t?new C().setFromMatrixPosition(t.matrix):this.controls.target;return e/(2*Math.tan(this.lens.fov*Math.PI/360)*Math.max(.05,n.distanceTo(this.lens.position)))}shape(t,e,n){this.lens.aspect=t/e,this.open=(t-n)/t,this.lens.setViewOffset(t,e,-n/2,0,t,e)}move({target:t,eye:e}){let{held:n}=this;this.held=!1,this.controls.target.copy(t),this.lens.position.copy(e),this.controls.update(),this.held=n}take(){this.goal=null,this.asked=!0,this.taken()}turn(t,e){this.take();let n=this.lens.position.clone().sub(this.controls.target);n.applyAxisAngle(new C(0,0,1),t);let s=new C().crossVectors(this.lens.up,n).normalize(),r=n.clone().applyAxisAngle(s,e),o=r.angleTo(this.lens.up);o>.02&&o<this.controls.maxPolarAngle&&n.copy(r),this.lens.position.copy(this.controls.target).add(n),this.controls.update()}zoom(t){this.take();let e=this.lens.position.clone().sub(this.controls.target).multiplyScalar(t);this.lens.position.copy(this.controls.target).add(e),this.controls.update()}};var jM=.11,QM=.0042,Xg=.5,t1=new C(0,1,0),Rh=class{group=new de;shaft;tip;material=new ri({depthTest:!1,transparent:!0,opacity:.95});constructor(t){this.shaft=new re(new Hi(t,t,1,12).translate(0,.5,0),this.material),this.tip=new re(new go(3*t,6*t,16).translate(0,3*t,0),this.material),this.group.add(this.shaft,this.tip),this.group.renderOrder=this.shaft.renderOrder=this.tip.renderOrder=8}show(t,e,n){let s=e.length();this.group.visible=s>.001,this.group.visible&&(this.group.position.copy(t),this.group.quaternion.setFromUnitVectors(t1,e.clone().divideScalar(s)),this.shaft.scale.set(n,s,n),this.tip.position.y=s,this.tip.scale.setScalar(Math.min(n,s/9)))}},Ch=class{group=new de;whole=new Rh(1);pressed=new Rh(.5);constructor(){this.group.add(this.whole.group,this.pressed.group),this.paint()}paint(){this.whole.material.color=new Ct(Et("force")),this.pressed.material.color=new Ct(Et("ink"))}show(t,e,n,s){let{force:r,normal:o,round:a}=t,l=r?Math.hypot(...r):0;if(this.group.visible=s&&l>Xg,!this.group.visible||!r)return;let c=jM/Math.max(10,a.normal.largest,l),h=QM*n.distanceTo(e);this.whole.show(e,new C(...r).multiplyScalar(c),h);let u=ji(a.plan.surface,e);this.pressed.show(e,u.multiplyScalar(Math.abs(o??0)>Xg?(o??0)*c:0),h)}};var e1=[[-1,-1],[1,-1],[1,1],[-1,1]];function n1({record:i,shape:t}){let e=Ve(i.places),[n,s]=i.cell.map(c=>aa*c),r=e.length/2,o=new Float32Array(12*r),a=[];for(let c=0;c<r;c++)e1.forEach(([h,u],d)=>o.set(Ji(t,e[2*c]+h*n,e[2*c+1]+u*s,Fn/2),12*c+3*d)),a.push(4*c,4*c+1,4*c+2,4*c,4*c+2,4*c+3);let l=new Ht;return l.setAttribute("position",new be(o,3)),l.setAttribute("color",new be(new Float32Array(12*r),3)),l.setIndex(a),l}var Ph=class{mesh=new re(new Ht,En(new ri({vertexColors:!0,side:pn,toneMapped:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),.997));shown=null;theme="";constructor(){this.mesh.matrixAutoUpdate=!1,this.mesh.frustumCulled=!1}show(t,e){if(this.mesh.visible=t!==null,!t)return;Te(t.pose,this.mesh.matrix),this.mesh.matrixWorldNeedsUpdate=!0;let n=this.shown?.record===t.record&&this.shown.shape===t.shape;n||(this.mesh.geometry.dispose(),this.mesh.geometry=n1(t)),(!n||this.shown?.values!==t.values||this.theme!==e)&&this.paint(t),this.shown=t,this.theme=e}paint({record:t,values:e}){let n=Ar(t),s=n.map(o=>new Ct(Et(o.colour))),r=this.mesh.geometry.getAttribute("color");e.forEach((o,a)=>{let{r:l,g:c,b:h}=s[Rr(n,t,o)];for(let u=0;u<4;u++)r.setXYZ(4*a+u,l,c,h)}),r.needsUpdate=!0}};function $g(i,t,e){jn(i),i.textAlign="center",i.textBaseline="middle";let{step:n,times:s}=jc(t.from,t.to,Math.max(2,t.span/76)),r=n<.1?2:n<1?1:0;for(let o of s){let a=t.x(o);Ye(i,a,e.top+e.height,a,t.height,"grid"),i.fillStyle=Et("quiet"),i.fillText(xe(o,r),Math.min(Math.max(a,t.left+10),t.width-16),e.top+e.height/2)}}function xa(i,t,e,n=1){if(e<i.from||t>i.to)return null;let s=Math.max(i.x(t),i.left);return[s,Math.max(Math.min(i.x(e),i.width-i.right),s+n)]}function qg(i,t,e,n){jn(i,11,600),i.textAlign="left",i.textBaseline="middle";for(let s of n.rounds){let r=xa(t,s.start,s.end);if(!r)continue;let[o,a]=r;i.fillStyle=Et("round"),i.beginPath(),i.roundRect(o+.5,e.top,Math.max(1,a-o-1),e.height,4),i.fill(),i.fillStyle=Et("ink"),Ts(i,`${s.number} \xB7 ${gh(n,s)}`,o+7,e.top+e.height/2+.5,a-o-12),s.start>t.from&&Ye(i,t.x(s.start),e.top,t.x(s.start),t.height,"rule")}}function Yg(i,t,e,n){jn(i,10.5),i.textAlign="left",i.textBaseline="middle";for(let{start:s,plan:r,length:o}of n.rounds)for(let a of r.phases){let l=xa(t,s+a.start,s+Math.min(a.end,Math.max(o,a.start)));if(!l)continue;let[c,h]=l;i.fillStyle=Et(a.contact?"wiping":"lane"),i.fillRect(c,e.top,Math.max(1,h-c-1),e.height),i.fillStyle=Et(a.contact?"ink":"quiet");let u=a.stroke===null?"":String(a.stroke+1),d=u?`${u} ${a.name}`:Ea(a.name),f=e.top+e.height/2+.5;u&&i.measureText(d).width>h-c-7?i.measureText(u).width<=h-c-3&&i.fillText(u,(c+h-i.measureText(u).width)/2,f):Ts(i,d,c+4,f,h-c-7)}}function Zg(i,t,e,n){i.fillStyle=Et("lane"),i.fillRect(t.left,e.top,t.span,e.height);for(let s of n.rounds){if(!xa(t,s.start,s.end))continue;let{contact:r,pushed:o}=s.contacts;for(let[a,l]of[["contact",r],["pushed",o]]){i.fillStyle=Et(a);for(let[c,h]of l){let u=xa(t,s.start+c,s.start+h);u&&(a==="contact"?i.fillRect(u[0],e.top,u[1]-u[0],e.height):i1(i,e,u))}}}}function i1(i,t,[e,n]){i.fillRect(e,t.top,n-e,t.height),i.save(),i.beginPath(),i.rect(e,t.top,n-e,t.height),i.clip();for(let s=e-t.height;s<n;s+=5)Ye(i,s,t.top+t.height,s+t.height,t.top,"paper",1.4);i.restore()}function Kg(i,t,e){if(!t.count)return;let n=Math.max(Math.floor(i.left),Math.floor(i.x(t.start))),s=Math.min(i.width-i.right,i.x(t.start+t.t.last)),r=t.place(i.t(n)-t.start)[0];for(let o=n;o<=s;o++){let a=t.place(i.t(o+1)-t.start)[0];e(o,r,Math.max(a,r+1)),r=a}}var af=({source:i,kind:t,byHand:e})=>i==="push"?"actual":/collision/i.test(t)?"collision":e?"hand":"event";function Jg(i,t,e,n){i.fillStyle=Et("lane"),i.fillRect(t.left,e.top,t.span,e.height);let s=e.top+e.height/2;for(let r of n.happenings){let o=xa(t,r.start,r.end,3);if(!o)continue;let[a,l]=o,c=af(r);if(i.fillStyle=i.strokeStyle=Et(c),r.source==="push"){i.lineWidth=1.5,i.setLineDash(ra),i.strokeRect(a+.5,e.top+1.5,Math.max(2,l-a-1),e.height-3),i.setLineDash([]);continue}i.fillRect(a,s-2.5,l-a,5),s1(i,c,a,s)}}function s1(i,t,e,n){i.beginPath(),t==="collision"?(i.moveTo(e-6,n+5.5),i.lineTo(e+6,n+5.5),i.lineTo(e,n-6),i.closePath()):t==="hand"?i.arc(e,n,5,0,2*Math.PI):i.rect(e-4,n-4,8,8),i.fill(),i.strokeStyle=Et("paper"),i.lineWidth=1,i.stroke()}var r1=13,Ih=class{points=new $n(new Ht,En(new Un({size:r1,sizeAttenuation:!1,vertexColors:!0,map:ah(),alphaTest:.3,transparent:!0}),.985));key="";starts=[];constructor(){this.points.frustumCulled=!1,this.points.renderOrder=7}show(t,e,n,s,r){let o=`${e.start} ${e.number} ${t.happenings.length} ${e.count>0} ${r}`;o!==this.key&&(this.key=o,this.build(t,e));let a=this.starts.filter(l=>l<=n).length;this.points.visible=s&&a>0,this.points.geometry.setDrawRange(0,a)}build(t,e){let n=[],s=[];this.starts=[];for(let r of t.happenings){let[o,a]=[r.start-e.start,r.end-e.start];if(o<0||o>e.length||r.source==="push"&&t.happenings.some(h=>h.source==="event"&&h.start<r.end&&h.end>r.start))continue;let c=e.toolAt((o+a)/2);c&&(this.starts.push(o),n.push(c[0],c[1],c[2]),s.push(...new Ct(Et(af(r))).toArray()))}this.points.geometry.dispose(),this.points.geometry=new Ht,this.points.geometry.setAttribute("position",new Nt(n,3)),this.points.geometry.setAttribute("color",new Nt(s,3))}};var o1=null;function Ls(){return o1??=a1()}function a1(){let i=document.createElement("canvas").getContext("webgl2");if(!i)return!0;let t=i.getExtension("WEBGL_debug_renderer_info"),e=/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t?String(i.getParameter(t.UNMASKED_RENDERER_WEBGL)):"");return i.getExtension("WEBGL_lose_context")?.loseContext(),e}var l1=26e5,jg=[.75,.6,.5],c1=1.5,h1=700,u1=70,d1=6,Lh=class{software=Ls();renderer;width=0;height=0;ratio=0;coarse=0;moved={last:0,took:0,frames:0};rest;constructor(t){this.renderer=new Gc({canvas:t,antialias:!this.software,alpha:!this.software,powerPreference:"high-performance"}),this.renderer.debug.checkShaderErrors=!1,this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=gs,this.renderer.shadowMap.autoUpdate=!this.software}hasShadows(t){return!this.software||t}get shadowSize(){return this.software?512:1024}size(t,e){[this.width,this.height,this.ratio]=[t,e,0]}paint(){this.software&&this.renderer.setClearColor(new Ct(Et("scene")))}draw(t,e,n,s){clearTimeout(this.rest),this.software&&!n&&this.keepUp(performance.now()),this.sharpen(n),this.renderer.shadowMap.needsUpdate=n,this.renderer.render(t,e),n||(this.rest=setTimeout(s,h1))}destroy(){clearTimeout(this.rest),this.renderer.dispose(),this.renderer.forceContextLoss()}keepUp(t){let{moved:e}=this,n=t-e.last;e.last=t,!(n>500)&&(e.took+=n,!(++e.frames<d1)&&(e.took/e.frames>u1&&this.coarse+1<jg.length&&this.coarse++,e.took=e.frames=0))}sharpen(t){let e=Math.sqrt(l1/(this.width*this.height)),n=Math.min(devicePixelRatio||1,2,Math.max(1,e)),s=this.software?t?Math.min(Math.max(c1,n),e):jg[this.coarse]:n;s!==this.ratio&&(this.ratio=s,this.renderer.setPixelRatio(s),this.renderer.setSize(this.width,this.height,!1))}};var lf=class{worldFromLink;joints;motion=new te;constructor(t){this.joints=t.map(e=>({...e,parentFromJoint:Te(e.pose),direction:new C(...e.axis)})),this.worldFromLink=Array.from({length:t.length+1},()=>new te)}update(t,e){Te(t,this.worldFromLink[0]),this.joints.forEach(({parent:n,parentFromJoint:s,direction:r,kind:o,offset:a,terms:l},c)=>{let h=a;for(let[d,f]of l)h+=f*(e[d]||0);let u=this.worldFromLink[c+1].multiplyMatrices(this.worldFromLink[n],s);o==="revolute"?u.multiply(this.motion.makeRotationAxis(r,h)):o==="prismatic"&&u.multiply(this.motion.makeTranslation(r.x*h,r.y*h,r.z*h))})}},Qg=()=>new Mn({transparent:!0,opacity:.22,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-2}),f1=.05;function p1(i,t,e){if(!(t.kind!=="capsule"||t.length<t.radius))for(let n of[-1,1]){let s=new Co(t.radius,f1*t.radius,8,40).translate(0,0,n*t.length/2),r=new re(s,e);r.matrixAutoUpdate=!1,Te(t.pose,r.matrix),i.add(r)}}var va=class{constructor(t,e,n,s){this.head=t;let{robot:r,tool:o}=t;this.tree=r?new lf(r.joints):null,this.parts=s?.parts??(r?.links??[]).map(({shapes:a})=>a.map(l=>({geometry:Mr(l,e),pose:l.pose,color:l.color}))),this.parts.forEach((a,l)=>{let c=new de;c.matrixAutoUpdate=!1;let h=l%2,{arm:u,visual:d}=r.links[l],f=l===o.link&&!d?n.hand:u?n.arm[h]:n.body[h];for(let{geometry:p,pose:x,color:m}of a){let g=new re(p,m?n.coloured(m):f);g.matrixAutoUpdate=!1,Te(x,g.matrix),g.castShadow=g.receiveShadow=!s,c.add(g)}if(!d&&f!==n.hand)for(let p of r.links[l].shapes)p1(c,p,n.ring);s||this.addCollision(c,r.links[l].collision??[],e,n.collision),this.links.push(c),this.group.add(c)}),this.toolGeometry=s?.toolGeometry??Mr(o.solid,e),this.tool=new re(this.toolGeometry,n.tool),this.tool.matrixAutoUpdate=!1,this.tool.castShadow=!s,this.linkFromTool=Te(o.solid.pose),this.group.add(this.tool)}head;group=new de;tree;links=[];collision=[];tool;linkFromTool;parts;toolGeometry;show(t,e,n){let s=this.tree!==null&&e.length>0;for(let a of this.links)a.visible=s;this.tree&&s&&(this.tree.update(t??[0,0,0,0,0,0,1],e),this.links.forEach((a,l)=>{a.matrix.copy(this.tree.worldFromLink[l]),a.matrixWorldNeedsUpdate=!0}));let{link:r}=this.head.tool,o=r!==null&&s?this.tree.worldFromLink[r]:void 0;this.tool.visible=o!==void 0||n!==null,o?this.tool.matrix.multiplyMatrices(o,this.linkFromTool):n&&Te(n,this.tool.matrix).multiply(this.linkFromTool),this.tool.matrixWorldNeedsUpdate=!0}set collisionShown(t){for(let e of this.collision)e.visible=t}addCollision(t,e,n,s){for(let r of e){let o=new re(Mr(r,n),s);o.matrixAutoUpdate=o.visible=!1,Te(r.pose,o.matrix),this.collision.push(o),t.add(o)}}get limbs(){return this.links.filter((t,e)=>e!==this.head.tool.link||this.head.robot.links[e].visual)}set last(t){for(let e of this.links)for(let n of e.children)n.renderOrder=t?9:0}get toolPlace(){return new C().setFromMatrixPosition(this.tool.matrix)}get rootPlace(){return new C().setFromMatrixPosition(this.links.find(t=>t.children.length)?.matrix??new te)}};var t0=5,e0=1.5,ya=.07,m1=.01,Dh=class{constructor(t,e,n){this.recording=t;this.robot=e;this.still=n;n.group.updateMatrixWorld(!0)}recording;robot;still;direction=null;get from(){let{count:t,over:e}=this.still.round;return(!this.direction||!e&&this.direction.samples!==t)&&(this.direction={samples:t,from:this.findDirection()}),this.direction.from}all(t){return this.move(t),g1(Es([...this.robot?[this.robot.group]:[],this.still.bodies]))}surface(){let t=this.surfaceCorners;if(!t.length)return this.all(0);let e=this.contacts.flatMap(n=>(this.move(n),this.robot?Es([this.robot.tool]):[]));return[...t,...e]}at(t){let{round:e}=this.still,n=e.plan.phases.filter(({contact:d})=>d),s=n.findIndex(({end:d})=>d>t),[r,o]=[n.at(s<0?-1:s-1),s<0?void 0:n[s]],a=s===0?0:r?.end??0,l=o?.start??e.length,c=(a+l)/2;if(o&&t>=Math.max(l-e0,Math.min(c,l)))return this.stroke(o);if(r&&s!==0&&t<Math.min(a+e0,c))return this.stroke(r);let h=[a,c,l].filter(d=>e.over||d<=e.t.last),u=[r,o].flatMap(d=>d?n0(e,d):[]);return{key:`${e.number} free ${a}`,points:[...(h.length?h:[t]).flatMap(d=>this.all(d)),...u]}}stroke(t){let e=n0(this.still.round,t);return{key:`${this.still.round.number} stroke ${t.start}`,points:e.length?e:this.surface()}}get surfaceCorners(){return this.still.surface?Es([this.still.surface]):[]}get contacts(){let{count:t,t:e,plan:n}=this.still.round,s=n.phases.filter(({contact:o,end:a})=>o&&t>0&&a<=e.last).map(({start:o,end:a})=>(o+a)/2),r=Math.max(1,s.length/t0);return Array.from({length:Math.min(t0,s.length)},(o,a)=>s[Math.floor(a*r)])}move(t){let{round:e}=this.still,n=this.recording.at(e.start+Math.min(t,e.length));n&&this.robot&&(this.robot.show(e.plan.root,n.q,n.tool),this.robot.group.updateMatrixWorld(!0))}findDirection(){let{plan:t}=this.still.round,e=this.contacts.map(l=>(this.move(l),{blocks:this.robot?Qc(this.robot.limbs):[],tool:this.robot?[this.robot.toolPlace,...Es([this.robot.tool])]:[]})),n=this.surfaceCorners,s=th(n),r=ji(t.surface,s),o=[s,...n.map(l=>l.clone().lerp(s,.15))].map(l=>l.clone().addScaledVector(r,m1)),a=this.robot&&e.length?s.clone().sub(this.robot.rootPlace):new C(.75,-1,0);return a.setZ(0).length()<.001&&a.set(1,0,0),_g(e,o,r,a.normalize().setZ(.6).normalize())}};function n0({plan:{strokes:i,surface:t}},{stroke:e}){let n=Tr(t.shape,nh(i[e??-1]??[]),!1),s=Te(t.pose);return n.flatMap(r=>{let{x:o,y:a,z:l}=new C(...r).applyMatrix4(s);return Array.from({length:8},(c,h)=>new C(o+(h&1?ya:-ya),a+(h&2?ya:-ya),l+(h&4?ya:0)))})}var g1=i=>i.length?i:[new C(-.5,-.5,0),new C(.5,.5,.5)];var Uh={believed:!0,estimated:!0,actual:!0,seen:!1,path:!0,strokes:!1,force:!0,events:!0,found:!0,actualSurface:!0,collision:!1},x1=9,v1=6,i0=.2,cf=new C(.9,.5,1.9),s0=1.7,r0=1.4,y1=Math.PI-r0-s0*cf.z/cf.length(),Nh=class{constructor(t,e,n){this.canvas=t;this.recording=e;this.left=n;this.painter=new Lh(t);let s=c=>this.painter.software?new Mn:new Lo({roughness:c,metalness:.05}),r=c=>Object.assign(s(c),{polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:2}),o=Object.assign(s(.5),{transparent:!0,opacity:i0,depthWrite:!1}),a=new Map,l=c=>{let[h,u,d,f]=c,p=a.get(c.join());if(p)return p;let x=Object.assign(s(.5),f<1?{depthWrite:!1}:{});return x.userData.opacity=f,x.color.setRGB(h,u,d,He),this.clear(x),a.set(c.join(),x),x};this.materials={body:[s(.6),r(.6)],arm:[s(.5),r(.5)],hand:o,ring:s(.4),collision:new ri({wireframe:!0,transparent:!0,opacity:.35}),tool:new Mn,coloured:l,own:a},this.scene.add(this.dirt.group,this.map.mesh,this.asked.group,this.force.group,this.marks.points,this.trajectories.group,this.axes.group,this.highlights,this.ghosts),this.camera=new Ah(t,()=>this.ask(),()=>this.leave()),t.addEventListener("webglcontextrestored",()=>this.ask()),this.paint()}canvas;recording;left;layers={...Uh};camera;painter;scene=new ao;materials;seeThrough=0;ground=new re(new ms(1,1),new Io({opacity:.14}));sun=null;grid=null;robot=null;ghosts=new de;ghostList=[];still=null;path=null;shots=null;entered=new Map;highlighted=[];highlights=new de;highlightLook=new en({linewidth:8,transparent:!0,opacity:.75,depthWrite:!1});trajectories=new ch;axes=new hh;dirt=new oh;map=new Ph;asked=new Sh;force=new Ch;marks=new Ih;begun=!1;chosen=!1;shot=null;sized=!1;apply=()=>{};first=null;moved=()=>this.draw();time=0;drawn=0;get ghostCount(){return this.ghosts.children.length}show(t){this.time=t,this.ask()}ask(){kn.draw(this.moved)}resize(t,e,n){if(!(!t||!e)){if(this.apply=()=>this.applySize(t,e,n),this.sized||!this.painter.software)return this.apply();this.first??=requestAnimationFrame(()=>setTimeout(()=>{this.canvas.isConnected&&this.apply()}))}}applySize(t,e,n){this.painter.size(t,e),this.camera.shape(t,e,n),this.chosen||(this.begun=!1),this.sized=!0,this.draw()}look(t){let e=this.recording.at(this.time);if(!this.shots||!e)return;this.shot=null,this.chosen=!0;let n=t==="all"?this.shots.all(e.time):this.shots.surface();this.camera.look(eh(n,t==="above"?new C(0,-.001,1):this.shots.from,this.camera.angles),!0),this.ask()}timeAt(t,e){if(!this.path||!this.layers.path)return null;let{clientWidth:n,clientHeight:s}=this.canvas,r=this.path.nearest(o=>(o.project(this.camera.lens),{x:(o.x+1)/2*n,y:(1-o.y)/2*s}),t,e,this.time-this.path.round.start,x1);return r===null?null:this.path.round.start+r}get follow(){return this.shot!==null}set follow(t){this.shot=t?"":null,this.chosen=!0,this.ask()}set xray(t){this.seeThrough=t;let{body:e,arm:n,hand:s,ring:r,own:o}=this.materials;for(let a of[...e,...n,r,...o.values()])this.clear(a);s.opacity=i0*(1-t),this.robot&&(this.robot.last=t>0),this.ask()}highlight(t){this.highlighted=t.map(({start:e,end:n})=>({from:e,to:n})),this.drawHighlights(),this.ask()}showTrajectories(t){this.trajectories.show(t),this.ask()}showParticles(t){this.asked.show(t),this.ask()}showFrames(t){this.axes.show(t),this.ask()}showGhosts(t){this.ghostList=t,this.ghosts.clear();let{head:e,meshes:n}=this.recording;if(e&&this.robot)for(let{time:s,color:r}of t){let o=this.recording.at(s);if(!o)continue;let a=Qg();a.color.set(Ii(r,Et("ghost")));let l=new va(e,n,{body:[a,a],arm:[a,a],hand:a,ring:a,collision:a,tool:a,coloured:()=>a},this.robot);l.show(o.round.plan.root,o.q,o.tool),this.ghosts.add(l.group)}this.ask()}paint(){let t=(l,c)=>l.color.set(Et(c)),{body:e,arm:n,hand:s,ring:r,collision:o,tool:a}=this.materials;t(e[0],"body-1"),t(e[1],"body-2"),t(n[0],"arm-1"),t(n[1],"arm-2"),t(s,"arm-1"),t(r,"ring"),t(o,"quiet"),t(a,"tool"),this.painter.paint(),this.showGhosts(this.ghostList),this.highlightLook.color.set(Et("highlight")),this.grid&&this.grid.material.color.set(Et("rule")),this.dirt.paint(),this.asked.paint(),this.force.paint();for(let{still:l,path:c}of this.entered.values())l.paint(),c.paint();this.ask()}picture(){return this.draw(!0),this.canvas.toDataURL("image/png")}destroy(){kn.drop(this.moved),this.camera.controls.dispose();for(let{still:t,path:e}of this.entered.values())t.dispose(),e.dispose();this.painter.destroy()}draw(t=!this.painter.software){let e=this.recording.at(this.time);this.sized&&(e&&this.place(e),this.sun&&(this.sun.castShadow=this.ground.visible=this.painter.hasShadows(t)),this.painter.draw(this.scene,this.camera.lens,t,()=>this.draw(!0)),this.drawn++)}place(t){let{head:e,meshes:n}=this.recording,{round:s,time:r}=t;!this.robot&&e&&(this.robot=new va(e,n,this.materials),this.scene.add(this.robot.group),this.showGhosts(this.ghostList)),this.still?.round!==s&&this.enter(t),this.aim(r),this.robot?.show(s.plan.root,t.q,t.tool);let o=t.phase>=0?s.plan.phases[t.phase].stroke:null;this.still.show({strokes:this.layers.strokes,found:this.layers.found,actual:this.layers.actualSurface},o,this.recording.foundAt(this.time)),this.robot&&(this.robot.collisionShown=this.layers.collision),this.still.fade(this.camera.lens.position),this.path.show(r,this.layers.path),this.dirt.scale(this.camera.pixelsPerMetre(this.still.surface,this.canvas.clientHeight)),this.dirt.show(this.recording,this.time,t,this.layers),this.map.show(sh(this.recording,this.time,s,this.layers),ws()),this.marks.show(this.recording,s,r,this.layers.events,ws()),this.robot&&this.force.show(t,this.robot.toolPlace,this.camera.lens.position,this.layers.force)}enter({round:t}){for(let n of[this.still?.group,this.path?.object])n&&this.scene.remove(n);let e=this.entered.get(t)??this.make(t);this.entered.delete(t),this.entered.set(t,e);for(let[n,{still:s,path:r}]of this.entered){if(this.entered.size<=v1)break;this.entered.delete(n),s.dispose(),r.dispose()}this.still=e.still,this.path=e.path,this.shots=e.shots,this.scene.add(this.still.group,this.path.object),this.drawHighlights()}make(t){let e=new ih(t,this.recording);return{still:e,path:new lh(t),shots:new Dh(this.recording,this.robot,e)}}aim(t){let{shots:e}=this;if(e){if(this.begun||(this.begun=!0,this.camera.look(eh(e.surface(),e.from,this.camera.angles)),this.grid||this.build(new cn().setFromPoints(e.all(t)).getBoundingSphere(new fn))),this.shot!==null){let{key:n,points:s}=e.at(t);n!==this.shot&&this.camera.look(eh(s,e.from,this.camera.angles),!0),this.shot=n}this.camera.step()&&this.ask()}}leave(){this.chosen=!0,this.shot!==null&&(this.shot=null,this.left())}clear(t){let e=(t.userData.opacity??1)*(1-this.seeThrough);t.opacity=e,t.transparent=e<1}drawHighlights(){for(let n of[...this.highlights.children])n.geometry.dispose(),this.highlights.remove(n);if(!this.path)return;let{start:t}=this.path.round,e=this.highlighted.flatMap(({from:n,to:s})=>this.path.between(n-t,s-t));e.length&&this.highlights.add(di(e,this.highlightLook))}build({center:t,radius:e}){let n=2*Math.min(60,Math.max(6,Math.ceil(3*e)));this.grid=new Go(n/2,n),this.grid.rotation.x=Math.PI/2,this.grid.position.set(Math.round(t.x),Math.round(t.y),0),Object.assign(this.grid.material,{vertexColors:!1,transparent:!0,opacity:.7}),this.grid.material.color.set(Et("rule")),this.ground.scale.setScalar(n/2),this.ground.position.set(this.grid.position.x,this.grid.position.y,-.001),this.ground.receiveShadow=!0;let s=new Fo(16777215,s0);s.position.copy(t).addScaledVector(cf,2*e),s.target.position.copy(t),this.sun=s,s.shadow.mapSize.set(this.painter.shadowSize,this.painter.shadowSize),s.shadow.bias=-5e-4,s.shadow.normalBias=.01,s.shadow.intensity=.4,s.shadow.radius=4,Object.assign(s.shadow.camera,{left:-1.4*e,right:1.4*e,top:1.4*e,bottom:-1.4*e,near:.1,far:9*e});let r=new No(16777215,9080728,r0);r.position.set(0,0,1),this.scene.add(this.grid,this.ground,s,s.target,r,new ko(16777215,y1));for(let[o,a]of[[[1,0,0],"axis-x"],[[0,1,0],"axis-y"],[[0,0,1],"axis-z"]]){let l=new en({linewidth:2.5});l.color.set(Et(a)),this.scene.add(di([0,0,.002,...o.map(c=>.25*c)],l))}}};var _1={believed:"Believed and predicted dirt",estimated:"Estimated dirt after the round",actual:"True dirt after the round",seen:"Observed dirt",path:"Tool path",strokes:"Planned strokes",force:"Force",events:"Events",found:"Surface found by touch",actualSurface:"True surface",collision:"Collision shapes"},Oh=class{constructor(t,e,n){this.recording=t;let s=S("canvas",{class:"w-canvas",tabindex:0,role:"application","aria-label":"Robot, tool and surface in 3-D. W A S D turn the scene, Z and X zoom."});this.stage=b1(s,t,()=>this.follow.setAttribute("aria-pressed","false"));let r=(f,p,x)=>S("button",{class:"w-button",type:"button",title:p,click:x},f);this.follow=r("Follow","Follow the work: wide in free motion, close at strokes  T",()=>this.toggleFollow()),this.follow.setAttribute("aria-pressed","false");let o=S("input",{type:"range",min:0,max:.95,step:.05,value:0,"aria-label":"Transparency of the robot",input:()=>{this.stage&&(this.stage.xray=Number(o.value))}}),a=S("div",{class:"w-views",role:"group","aria-label":"View"},r("Fit","Show all of robot and surface  F",()=>this.look("all")),r("Surface","Close view of the surface",()=>this.look("surface")),r("Above","View from above  V",()=>this.look("above")),this.follow,S("label",{class:"w-button w-xray",title:"Look through the robot"},"X-ray",o));if(this.element=S("section",{class:"w-scene","aria-label":"Scene"},this.stage?s:S("p",{class:"w-none"},"This browser cannot draw 3-D graphics. The other panels still work."),this.stage&&a,this.stage&&this.legend(e),this.scale,this.extra,this.still),!this.stage)return;let{stage:l}=this,c=!1,h=()=>{let{clientWidth:f,clientHeight:p}=s,x=this.element.querySelector(".w-layers");!c&&f&&f<=640&&x&&(x.open=!1),c||=f>0,l.resize(f,p,x?.open&&f>640?x.offsetWidth:0)},u=new ResizeObserver(h);u.observe(s),this.element.addEventListener("toggle",h,!0);let d={x:0,y:0};s.addEventListener("pointerdown",({offsetX:f,offsetY:p})=>{d={x:f,y:p}}),s.addEventListener("click",({offsetX:f,offsetY:p})=>{if(Math.hypot(f-d.x,p-d.y)>3)return;let x=l.timeAt(f,p);x!==null&&n(x)}),this.stop.push(()=>u.disconnect(),wr(()=>{l.paint(),Sr()&&(this.still.src=l.picture())}))}recording;element;stage;boxes=new Map;extra=S("ul",{class:"w-named"});follow;still=S("img",{class:"w-still",alt:"The robot and the surface at the shown time"});stop=[];mapTitle=S("strong");scale=S("div",{class:"w-scene-scale",hidden:!0},this.mapTitle);scaleOf=null;treats=!1;version=-1;time=0;show(t){if(this.stage?.show(t),this.time=t,this.showScale(),this.version===this.recording.version)return;this.version=this.recording.version;let{rounds:e,observedBefore:n}=this.recording,s={believed:e.some(a=>fi(a)?a.treated!==null:a.plan.particles.length>0),estimated:e.some(a=>(fi(a)?a.interpreted?.treated:a.interpreted)!=null),actual:e.some(a=>(fi(a)?a.truth?.treated:a.truth?.particles)!=null),seen:n!==null||e.some(({observed:a})=>a!==null),path:e.some(({count:a})=>a>0),strokes:e.some(({plan:a})=>a.strokes.length>0),force:e.some(({count:a})=>a>0),events:this.recording.happenings.length>0,found:e.some(({interpreted:a})=>a?.found!=null),collision:this.recording.head?.robot?.links.some(({collision:a})=>a?.length)??!1,actualSurface:e.some(({truth:a})=>a?.surface!=null)},r=e.find(fi);this.stage&&r&&!this.treats&&this.nameMaps(r);for(let[a,l]of this.boxes)l.hidden=!s[a];let o=this.element.querySelector(".w-layers");o&&(o.hidden=!Object.values(s).some(Boolean))}showScale(){let t=this.stage&&this.recording.roundAt(this.time),e=t&&sh(this.recording,this.time,t,this.stage.layers);this.scale.hidden=!e,e&&($t(this.mapTitle,e.title),this.scaleOf!==e.record&&(this.scaleOf=e.record,this.scale.replaceChildren(this.mapTitle,tf(e.record))))}nameMaps(t){this.treats=!0;let e=Qi(t),n={believed:`Predicted ${e}`,estimated:`Estimated ${e} after the round`,actual:`True ${e} after the round`};for(let[s,r]of Object.entries(n))this.boxes.get(s)?.querySelector("label").replaceChildren(pa("map"),r);this.stage.layers.actual=!1,this.boxes.get("actual").querySelector("input").checked=!1}look(t){this.follow.setAttribute("aria-pressed","false"),this.stage?.look(t)}toggleFollow(){this.stage&&(this.stage.follow=!this.stage.follow,this.follow.setAttribute("aria-pressed",String(this.stage.follow)))}name(t){this.extra.replaceChildren(...t.map(({name:e,colour:n,form:s})=>{if(s)return S("li",{},Ug(n,s==="estimated"),e);let r=S("i",{"aria-hidden":"true"});return r.style.background=n,S("li",{},r,e)}))}destroy(){for(let t of this.stop)t();this.stage?.destroy()}legend(t){let e=Object.keys(Uh).map(n=>{let s=Aa(),r=S("input",{type:"checkbox",id:s,checked:Uh[n],change:()=>{this.stage&&(this.stage.layers[n]=r.checked,this.stage.ask(),this.showScale())}}),o=S("li",{},r,S("label",{for:s},pa(n),_1[n]));return this.boxes.set(n,o),o});return S("details",{class:"w-layers",open:!t},S("summary",{},"Layers"),S("ul",{},...e))}};function b1(i,t,e){try{return new Nh(i,t,e)}catch{return null}}var w1=170,hf=15,o0=8,uf=3,S1=3;function M1(i,t,e){let n=({label:l,count:c})=>Math.min(w1,t(a0(l,c))),s=[],r=new Map;for(let{x:l,label:c}of[...i].sort((h,u)=>h.x-u.x)){let h=r.get(c);if(h&&l<h.x+n(h)+o0){h.count++;continue}let u={x:l,label:c,count:1};s.push(u),r.set(c,u)}let o=Array.from({length:S1},()=>-1/0),a=[];for(let l of s){let c=n(l),h=Math.min(l.x,e-c),u=o.findIndex(d=>d+o0<=h);u<0||(o[u]=h+c,a.push({text:a0(l.label,l.count),x:h,width:c,row:u}))}return a}var a0=(i,t)=>t>1?`${i} \xD7${t}`:i;function l0(i,t,e){let n=t.lane("rounds")?.top??0,s=t.width-t.right,r=[];i.fillStyle=Et("highlight");for(let{start:o,end:a,label:l}of e){if(a<t.from||o>t.to)continue;let c=Math.max(t.left,t.x(o)),h=Math.max(c+2,Math.min(s,t.x(a)));i.globalAlpha=.28,i.fillRect(c,n,h-c,t.height-n),i.globalAlpha=1,i.fillRect(c,n-3,h-c,3),l&&r.push({x:c+uf,label:l})}jn(i,10,600),i.textAlign="left",i.textBaseline="middle";for(let{text:o,x:a,width:l,row:c}of M1(r,h=>i.measureText(h).width,s)){let h=t.height-4-(c+.5)*hf;i.globalAlpha=.85,i.fillStyle=Et("paper"),i.beginPath(),i.roundRect(a-uf,h-hf/2+1,l+2*uf,hf-2,3),i.fill(),i.globalAlpha=1,i.fillStyle=Et("ink"),Ts(i,o,a,h+.5,l+1)}}function c0(i,t,e,n,s,r,o){let a=l=>e.top+e.height-(l-n)/(s-n)*e.height;jn(i,10),i.textAlign="right",i.textBaseline="middle";for(let l of xg(n,s,r))Ye(i,t.left,a(l),t.width-t.right,a(l),Math.abs(l)<1e-12?"rule":"grid"),i.fillStyle=Et("quiet"),i.fillText(o(l),t.left-5,Math.min(Math.max(a(l),e.top+4),e.top+e.height-3));return a}function h0(i,t,e,n){i.save(),i.beginPath(),i.rect(t.left-1,e.top-2,t.span+2,e.height+4),i.clip(),n(),i.restore()}function df(i,t,e,n,s,r){let[o,a]=[0,r.least];for(let h of n.rounds){let{least:u,largest:d}=s(h);u<=d&&([o,a]=[Math.min(o,u*r.unit),Math.max(a,d*r.unit)])}r.bounds&&([o,a]=[Math.max(o,r.bounds[0]),Math.min(a,r.bounds[1])]);let l=.06*(a-o),c=c0(i,t,e,o<0?o-l:0,a+l,3,h=>String(Number(h.toPrecision(3))).replace("-","\u2212"));h0(i,t,e,()=>{for(let h of n.rounds){if(h.end<t.from||h.start>t.to||!h.count)continue;i.strokeStyle=Et(r.name),i.lineWidth=1.5,i.lineJoin="round",i.beginPath();let u=s(h);h.count*((t.to-t.from)/Math.max(h.length,1e-9))>4*t.span?E1(i,t,h,u,f=>c(f*r.unit)):T1(i,t,h,u,f=>c(f*r.unit)),i.stroke()}})}function T1(i,t,e,n,s){let r=e.place(t.from-e.start)[0],o=Math.min(e.count,e.place(t.to-e.start)[0]+2),a=!1;for(let l=r;l<o;l++){let c=n.data[l];if(!Number.isFinite(c)){a=!1;continue}let h=t.x(e.start+e.t.data[l]);a?i.lineTo(h,s(c)):i.moveTo(h,s(c)),a=!0}}function E1(i,t,e,n,s){let r=!1;Kg(t,e,(o,a,l)=>{let c=n.range(a,l+1);if(!c){r=!1;return}let[h,u]=[s(c[1]),s(c[0])];r?i.lineTo(o,u):i.moveTo(o,u),i.lineTo(o,u-h<.7?u-.7:h),r=!0})}var A1=14;function u0(i,t,e,n){let s=c0(i,t,e,0,1,2,a=>String(Math.round(100*a))),r=n.head?.task?.target,o=t.width-t.right;h0(i,t,e,()=>{r!==void 0&&(i.setLineDash([6,4]),Ye(i,t.left,s(r),o,s(r),"target",1.5),i.setLineDash([]));for(let a of n.rounds)a.end<t.from||a.start>t.to||R1(i,t,a,s)}),n.rounds.forEach((a,l)=>{if(!a.interpreted||a.end>t.to+1e-9)return;let c=C1(t,a,n.rounds[l+1]);c&&P1(i,c,a.interpreted.estimate,s),a.end>=t.from&&I1(i,t,a,s)}),r!==void 0&&(jn(i,10),i.fillStyle=Et("target"),i.textAlign="left",i.textBaseline=r>.8?"top":"bottom",i.fillText(`target ${Math.round(100*r)}\u202F%`,t.left+5,s(r)+(r>.8?3:-2)))}function R1(i,t,e,n){let s=e.plan.growth;if(!s.length)return;i.strokeStyle=Et("believed"),i.lineWidth=2.2,i.lineCap="round",i.setLineDash(gg),i.beginPath(),s.forEach(([o,a],l)=>{let c=t.x(e.start+Math.min(o,e.length));l?i.lineTo(c,n(a)):i.moveTo(c,n(a))});let r=s.at(-1);r[0]<e.length&&i.lineTo(t.x(e.end),n(r[1])),i.stroke(),i.setLineDash([]),i.lineCap="butt"}function C1(i,t,e){let n=i.x(t.end),s=e?i.x(e.start+e.firstContact):0,[r,o]=[Math.max(n,i.left),Math.min(Math.max(n+A1,s),i.width-4)];return o>r?[r,o]:null}function P1(i,[t,e],{mean:n,low:s,high:r},o){i.fillStyle=Et("interval"),i.fillRect(t,o(r),e-t,Math.max(1,o(s)-o(r)));for(let a of[s,r])Ye(i,t,o(a),e,o(a),"estimated",1);Ye(i,t,o(n),e,o(n),"estimated",2.4)}function I1(i,t,e,n){let{estimate:s,by_touch:r}=e.interpreted,o=t.x(e.end),a=e.growthAt(e.length);a!==null&&L1(i,o,n(a),n(s.mean)),(r.low!==s.low||r.high!==s.high)&&D1(i,o-13,n,r,"by-touch",1.4,3);let l=e.truth?.performance??null;if(l===null)return;let c=n(l);for(let[h,u]of[[5,"paper"],[2.4,"actual"]])Ye(i,o+3,c-4.5,o+12,c+4.5,u,h),Ye(i,o+12,c-4.5,o+3,c+4.5,u,h)}function L1(i,t,e,n){if(Ye(i,t,e,t,n,"ink",1.4),Math.abs(n-e)<8)return;let s=6*Math.sign(e-n);Ye(i,t-3.5,n+s,t,n,"ink",1.4),Ye(i,t+3.5,n+s,t,n,"ink",1.4)}function D1(i,t,e,{mean:n,low:s,high:r},o,a,l){Ye(i,t,e(s),t,e(r),o,a),Ye(i,t-l,e(s),t+l,e(s),o,a),Ye(i,t-l,e(r),t+l,e(r),o,a),i.fillStyle=Et(o),i.beginPath(),i.arc(t,e(n),1.7*a,0,2*Math.PI),i.fill()}function d0(i,t){let e=new Map,n=!1,s=a=>{let{left:l,width:c}=i.getBoundingClientRect();return(a.clientX-l)*(i.clientWidth/c||1)},r=()=>{let[a=0,l=0]=[...e.values()];return{middle:(a+l)/2,distance:Math.max(10,Math.abs(a-l))}};i.addEventListener("pointerdown",a=>{a.button!==0||a.target instanceof HTMLButtonElement||(e.set(a.pointerId,s(a)),i.setPointerCapture(a.pointerId),i.focus({preventScroll:!0}),e.size===1?(n=!1,t.seek(s(a))):n=!0)}),i.addEventListener("pointermove",a=>{if(!e.has(a.pointerId)){t.hover(s(a));return}let l=r();if(e.set(a.pointerId,s(a)),e.size===2){let c=r();t.zoom(l.middle,l.distance/c.distance,c.middle-l.middle)}else n||(t.hover(s(a)),t.seek(s(a)))});let o=a=>{e.delete(a.pointerId),a.pointerType!=="mouse"&&t.hover(null)};i.addEventListener("pointerup",o),i.addEventListener("pointercancel",o),i.addEventListener("pointerleave",()=>t.hover(null)),i.addEventListener("dblclick",()=>t.reset()),i.addEventListener("wheel",a=>{let{scrollHeight:l,clientHeight:c}=document.documentElement,h=Math.abs(a.deltaX)>Math.abs(a.deltaY)||a.shiftKey;if(!(a.ctrlKey||h||i.contains(document.activeElement)||l<=c+1))return;a.preventDefault();let d=a.shiftKey&&!a.deltaX?a.deltaY:h?a.deltaX:a.deltaY;h?t.zoom(s(a),1,-d):t.zoom(s(a),Math.exp(Math.max(-1,Math.min(1,d*.002))),0)},{passive:!1})}var N1=["axis","rounds","phases","contact","events","force","height","performance"],U1=["axis","rounds","phases","contact","events","force"],O1=[-20,80],F1=700,f0=700,p0={card:60,software:250},m0=.2,Fh=class{constructor(t,e,n){this.recording=t;this.clock=e;this.frame=new Jc(n?U1:N1),this.element=S("div",{class:"w-timeline",role:"slider",tabindex:0,"aria-label":"Time in the run","aria-valuemin":0,"aria-keyshortcuts":"Space ArrowLeft ArrowRight [ ] Home End"},this.base,this.veil,this.hair,this.cursor,this.whole,this.tip),d0(this.element,{seek:r=>{e.playing&&e.pause(),e.seek(this.frame.t(Math.min(Math.max(r,this.frame.left),this.frame.width-this.frame.right)))},hover:r=>this.hover(r),zoom:(r,o,a)=>this.zoom(r,o,a),reset:()=>this.reset()});let s=new ResizeObserver(()=>this.resize());s.observe(this.element),requestAnimationFrame(()=>{let r=this.element.closest(".w-view");r&&s.observe(r)}),this.stop.push(()=>s.disconnect(),e.subscribe(()=>this.ask()),t.onChange(()=>this.ask()),wr(()=>this.resize()))}recording;clock;element;base=S("canvas",{"aria-hidden":"true"});cursor=S("i",{class:"w-cursor","aria-hidden":"true"});hair=S("i",{class:"w-hair","aria-hidden":"true",hidden:!0});veil=S("i",{class:"w-veil","aria-hidden":"true",hidden:!0});whole=S("button",{class:"w-button w-whole",type:"button",hidden:!0,title:"Show the whole run  (double-click)",click:()=>this.reset()},"Whole run");tip=S("div",{class:"w-tip",hidden:!0});frame;stop=[];highlights=[];zoomed=!1;drawn={version:-1,duration:-1,at:-1/0};later;moved=()=>this.draw();stale=!0;hovered=null;highlight(t){this.highlights=t,this.redraw()}redraw(){this.stale=!0,this.ask()}destroy(){kn.drop(this.moved),clearTimeout(this.later);for(let t of this.stop)t()}ask(){kn.draw(this.moved)}resize(){let t=Sr()?F1:this.element.clientWidth;if(!t)return;this.frame.layOut(t,Sr()||(this.element.closest(".w-view")?.clientHeight??f0)<f0);let e=this.element.currentCSSZoom??1,n=Sr()?3:Math.min((devicePixelRatio||1)*e,2);this.base.width=Math.round(t*n),this.base.height=Math.round(this.frame.height*n),this.base.style.width=`${t}px`,this.base.style.height=`${this.frame.height}px`,this.element.style.height=`${this.frame.height}px`,this.stale=!0,kn.drop(this.moved),this.draw()}reset(){this.zoomed=!1,this.redraw()}zoom(t,e,n){let{frame:s}=this,r=Math.max(this.clock.duration,m0),o=s.t(t),a=Math.min(r,Math.max(m0,(s.to-s.from)*e)),l=(o-s.from)/(s.to-s.from),c=o-l*a-n/s.span*a;c=Math.min(Math.max(0,c),r-a),[s.from,s.to]=[c,c+a],this.zoomed=a<r*.999,this.redraw()}pen(){let t=this.base.getContext("2d",{willReadFrequently:Ls()}),e=this.base.width/(parseFloat(this.base.style.width)||1);return t.setTransform(e,0,0,e,0,0),t.clearRect(0,0,this.frame.width,this.frame.height),t}draw(){let{recording:t,clock:e,frame:n}=this,{duration:s}=e;this.zoomed?(e.playing||e.following)&&this.scrollToCursor():[n.from,n.to]=[0,Math.max(s,.001)],this.isDue()&&(this.drawBase(),this.drawn={version:t.version,duration:s,at:performance.now()},this.stale=!1),this.whole.hidden=!this.zoomed,this.moveOverlays();let{element:r}=this;r.setAttribute("aria-valuemax",s.toFixed(1)),r.setAttribute("aria-valuenow",e.time.toFixed(2));let o=t.at(e.time),a=o?.round.plan.phases[o.phase]?.name;r.setAttribute("aria-valuetext",`${xe(e.time)}${o?`, round ${o.round.number}`:""}${a?`, ${a}`:""}`)}isDue(){let{recording:t,clock:e,drawn:n}=this;if(this.stale||n.duration!==e.duration)return!0;if(n.version===t.version)return!1;let s=Ls()?p0.software:p0.card,r=t.live?n.at+s-performance.now():0;return r<=0?!0:(clearTimeout(this.later),this.later=setTimeout(()=>this.ask(),r),!1)}scrollToCursor(){let{frame:t,clock:e}=this,n=t.to-t.from;if(e.time>=t.from&&e.time<=t.to-.03*n)return;let s=Math.min(Math.max(0,e.time-.1*n),Math.max(0,e.duration-n));Math.abs(s-t.from)<1e-9||([t.from,t.to]=[s,s+n],this.stale=!0)}drawBase(){let{frame:t,recording:e}=this,n=this.pen();for(let s of t.lanes){switch(s.name){case"axis":$g(n,t,s);break;case"rounds":qg(n,t,s,e);break;case"phases":Yg(n,t,s,e);break;case"contact":Zg(n,t,s,e);break;case"events":Jg(n,t,s,e);break;case"force":df(n,t,s,e,o=>o.normal,{name:"force",unit:1,least:5});break;case"height":df(n,t,s,e,o=>o.height,{name:"height",unit:1e3,least:10,bounds:O1});break;case"performance":u0(n,t,s,e);break}jn(n),n.fillStyle=Et("quiet"),n.textAlign="left",n.textBaseline="middle";let r=Fd.has(s.name);t.narrow?r&&n.fillText(s.label,2,s.top-8):s.label.split(`
`).forEach((o,a)=>Ts(n,o,2,s.top+(r?8+13*a:s.height/2),t.left-(r?26:6)))}l0(n,t,this.highlights),this.drawVeil()}moveOverlays(){let{frame:t,clock:e}=this,n=t.width-t.right,s=t.x(e.time);this.cursor.hidden=s<t.left-1||s>n+1,this.cursor.style.transform=`translateX(${s.toFixed(1)}px)`,this.hair.hidden=this.hovered===null,this.hovered!==null&&(this.hair.style.transform=`translateX(${this.hovered}px)`)}drawVeil(){let{frame:t,recording:e}=this,n=t.width-t.right,s=Math.min(n,Math.max(t.left,t.x(e.now)));this.veil.hidden=!e.live||s>=n,Object.assign(this.veil.style,{left:`${s}px`,width:`${n-s}px`})}hover(t){let{frame:e}=this,n=t!==null&&t>=e.left&&t<=e.width-e.right;this.hovered=n?t:null,this.tip.hidden=!n,n&&($t(this.tip,this.describe(e.t(t)).join(`
`)),this.tip.style.left=`${Math.max(2,Math.min(t-this.tip.offsetWidth/2,e.width-this.tip.offsetWidth-2))}px`),this.ask()}describe(t){let e=this.recording.at(t);if(!e)return[xe(t,2)];let{round:n,normal:s,height:r,performance:o,phase:a,contact:l}=e,c=4*((this.frame.to-this.frame.from)/this.frame.span),h=this.recording.happenings.filter(({start:f,end:p})=>t>=f-c&&t<=p+c),u=this.highlights.filter(({start:f,end:p,label:x})=>x&&t>=f-c&&t<=p+c).map(({label:f})=>f),d=this.recording.rounds.findLast(f=>f.interpreted&&Math.abs(t-f.end)<4*c)??this.recording.resultAt(t);return[`${xe(t,2)} \xB7 round ${n.number}`,n.plan.phases[a]?.name??"",s===null?"":`force ${me(s,1)} N`,r===null?"":`height ${me(1e3*r,1)} mm`,l==="none"?"":l==="pushed"?`pushed by somebody or something${r!==null&&r>Jh?", not on the surface":""}`:"contact with the surface",o===null?"":`performance ${Yt(o)} predicted`,...d?k1(d):[],...new Set(u),...h.map(({kind:f,words:p})=>`${f}: ${p}`)].filter(f=>f!=="")}};function k1(i){let{estimate:t}=i.interpreted,e=i.growthAt(i.length);return[`performance after round ${i.number}: ${Is(t)} estimated`,e===null?"":`the estimate after round ${i.number} replaces the prediction of ${Yt(e)}`,typeof i.truth?.performance=="number"?`true performance after round ${i.number}: ${Yt(i.truth.performance)}`:""]}function g0(i,t){let e=S("button",{class:"w-button w-play",type:"button",click:()=>i.toggle()}),n=h=>S("button",{class:"w-button w-icon",type:"button","aria-label":h<0?"Previous event or stroke":"Next event or stroke",title:h<0?"Previous event or stroke  [":"Next event or stroke  ]",click:()=>i.seek(bh(t.stops,i.time,h))},Qd(h<0?"before":"after")),s=S("button",{class:"w-button w-live",type:"button",title:"Follow the live run  L",click:()=>i.follow()},"LIVE"),r=S("output",{class:"w-time","aria-live":"off"}),o=S("select",{class:"w-select","aria-label":"Playback speed",change:()=>i.setSpeed(Number(o.value))},...Pr.map(h=>S("option",{value:h},`${h}\xD7`))),a=S("details",{class:"w-keys"},S("summary",{},"Keys"),S("dl",{},...Bg.flatMap(([h,u])=>[S("dt",{},h),S("dd",{},u)]))),l=null,c=()=>{let h=i.playing||i.following;h!==l&&(l=h,e.replaceChildren(Qd(h?"pause":"play"),S("span",{},h?"Pause":"Play")),e.setAttribute("aria-label",h?"Pause":"Play")),s.hidden=!i.live,s.setAttribute("aria-pressed",String(i.following)),$t(r,`${xe(i.time)} / ${xe(i.duration)}${i.isLate?" (slower than real time)":""}`),Number(o.value)!==i.speed&&(o.value=String(i.speed))};return c(),{element:S("div",{class:"w-transport",role:"group","aria-label":"Playback"},e,n(-1),n(1),s,r,o,a),show:c}}var B1=150;function _a(i,t,{compact:e=!1,clock:n}={}){let s=n??new Ir,r=s.join(t),o=new Oh(t,e,M=>{s.playing&&s.pause(),s.seek(M)}),a=new Fh(t,s,e),l=e?null:new vh(t,s),c=g0(s,t),h=S("div",{class:`w-view${e?" w-compact":""}`},S("div",{class:"w-grid"},o.element,l?.element,S("div",{class:"w-below"},c.element,a.element)));i.append(h);let u=mh(Ls()?B1:0,()=>{l?.show(),c.show()}),d=()=>{o.show(s.time),u.ask()},f=()=>kn.draw(d),p=[r,s.subscribe(f),t.onChange(()=>{s.onGrowth(),f()}),zg(h,s,t,M=>{if(M==="f")o.look("all");else if(M==="v")o.look("above");else if(M==="t")o.toggleFollow();else if(M==="l"&&s.live)s.follow();else return!1;return!0})];t.live&&s.follow(),d();let x={trajectories:[],ghosts:[],frames:[],particles:[]},m=()=>o.name([...x.trajectories.map(({name:M,color:v},T)=>({name:M,colour:uh(v,T)})),...x.ghosts.map(({time:M,color:v})=>({name:`${t.head?.robot?"robot":"tool"} at ${xe(M)}`,colour:Ii(v,Et("ghost"))})),...x.frames.map(({name:M,color:v})=>({name:M,colour:Ii(v,Et("axis-z"))})),...x.particles.map(({name:M,color:v,state:T})=>({name:M,colour:wh(v),form:T}))]),g=M=>{x.trajectories=M,o.stage?.showTrajectories(M),m()},b=M=>{x.ghosts=M,o.stage?.showGhosts(M),m()},A=M=>{x.frames=M,o.stage?.showFrames(M),m()},y=M=>{x.particles=M,o.stage?.showParticles(M),m()},E=M=>{a.highlight(M),o.stage?.highlight(M)};return{element:h,clock:s,showTrajectories:g,showRobotAt:b,showFrames:A,showParticles:y,highlight:E,seek:M=>s.seek(M),clearShown:()=>{g([]),b([]),A([]),y([]),E([])},get frames(){return o.stage?.drawn??0},get ghosts(){return o.stage?.ghostCount??0},camera:o.stage?.camera??null,destroy:()=>{kn.drop(d),u.stop();for(let M of p)M();o.destroy(),a.destroy(),n||s.destroy(),h.remove()}}}function ff(i){let t=new URLSearchParams(i.replace(/^#/,"")),e=Number.parseFloat(t.get("t")??""),n={time:Number.isFinite(e)&&e>=0?e:null,query:t.get("q")||null};for(let r of["episode","run"]){let o=t.get(r);if(o)return{kind:r,ids:[o],...n}}let s=(t.get("compare")??"").split(",").filter(r=>r);return s.length===2?{kind:"compare",ids:s,...n}:{kind:"home",ids:[],...n}}function is({kind:i,ids:t,time:e,query:n}){let s=[];return i!=="home"&&s.push(`${i}=${t.map(encodeURIComponent).join(",")}`),e!==null&&i!=="home"&&s.push(`t=${e.toFixed(1)}`),n&&s.push(`q=${encodeURIComponent(n)}`),s.length?`#${s.join("&")}`:""}var x0=(i,t)=>i.kind===t.kind&&i.ids.join()===t.ids.join();function v0(i){let t=is(i);t!==location.hash&&history.replaceState(null,"",t||location.pathname)}var Ur=["A","B"],z1=500,[Ds,pf,y0]=[52,14,18],kh={force:96,performance:110},G1=30,ba=(i,t,e=1)=>n=>{let s=me(e*n,t);return`${n>0?"+":""}${s}${i&&`\u202F${i}`}`},Bh=ba("points",0,100);function V1({rounds:i}){if(!i.some(({count:e})=>e))return null;let t=0;for(let e of i){let{data:n}=e.tool;for(let s=1;s<e.count;s++){let r=Math.hypot(...[0,1,2].map(o=>n[7*s+o]-n[7*s-7+o]));Number.isFinite(r)&&e.contactAt(e.t.data[s])==="contact"&&(t+=r)}}return t}function H1({happenings:i}){let t=new Map;for(let{source:e,kind:n}of i)e==="event"&&t.set(n,(t.get(n)??0)+1);return[...t].map(([e,n])=>`${n} \xD7 ${e}`).join(", ")||"none"}function _0(i){let{head:t,rounds:e,ended:n}=i,{state:s,text:r}=Dr(i),o=t?.task,a=e.flatMap(({plan:m})=>m.considered?.find(g=>g.chosen)?.strategy??[]),l=e.findLast(({interpreted:m})=>m)??e.at(-1),c=l?.interpreted,h=s==="unknown",u=l?.plan.predicted??null,d=l?.truth?.performance??null,f=Math.max(...e.map(({normal:m})=>m.largest)),p=V1(i),x=c?Is(c.estimate,h?n.verdict:void 0):Bn;return[{label:"Task",text:o?`${o.action} on ${o.surface}`:Bn},{label:"Medium",text:o?.medium??Bn},{label:"Tool",text:o?.tool??Bn},{label:"Strategy",text:o?[o.strategy,...a.length?[`chosen: ${a.join(", ")}`]:[]].join("; "):Bn},{label:"Target",text:gn(o?.target,Yt),value:o?.target??null,by:Bh},{label:"Rounds",text:String(e.length),value:e.length,by:ba("",0)},{label:"Predicted, last round",text:gn(u,Yt),value:u,by:Bh},{label:"Estimated, last round",text:x,value:h?null:c?.estimate.mean??null,by:Bh},{label:"True, last round",text:gn(d,Yt),value:d,by:Bh},{label:"Way in contact",text:gn(p,m=>`${me(m,2)} m`),value:p,by:ba("m",2)},{label:"Duration",text:xe(i.duration),value:i.duration,by:ba("s",1)},{label:"Largest force",text:f>0?`${me(f,1)} N`:Bn,value:f>0?f:null,by:ba("N",1)},{label:"Events",text:H1(i)},{label:"Result",text:r}]}function W1(i,t){let e=_0(t);return _0(i).map(({label:n,text:s,value:r,by:o},a)=>{let l=e[a],c=typeof r=="number"&&typeof l.value=="number",h=(o?c:s!==Bn)?"":Bn;return{label:n,texts:[s,l.text],by:s===l.text?h:c?o(l.value-r):"differs"}})}function X1(i,t,e,n){return Array.from({length:n},(s,r)=>{let[o,a]=[r*e/n,(r+1)*e/n],l=i.roundAt(o);if(!l?.count||o>l.start+l.t.last)return null;let c=l.place(o-l.start)[0];return t(l).range(c,Math.max(c,l.place(a-l.start)[0])+1)})}var mf=(i,t,e,n,s={})=>yt("text",{x:i,y:t,"text-anchor":n,"font-size":11,fill:"var(--quiet)",...s},e),b0=i=>i?{"stroke-width":1.2}:{"stroke-width":3,"stroke-opacity":.7},w0=i=>`var(--${i?"second":"first"})`,zh=class{constructor(t,e,n){this.pair=t;this.clock=n;let s=t.map(({head:l},c)=>S("li",{},gf(c),[l?.title,e[c]].filter(h=>h).join(" \xB7 "))),r="Line: predicted performance. Bar and dot: estimate with its 90\u202F% interval after a round. Cross: true.";this.element=S("section",{class:"s-compare","aria-label":"Comparison"},S("div",{},S("ul",{class:"w-legend"},...s),this.plots,S("p",{class:"w-quiet s-remark"},r)),this.table);let o=mh(z1,()=>this.draw()),a=new ResizeObserver(()=>o.ask());a.observe(this.plots),this.stops.push(()=>a.disconnect(),o.stop,n.subscribe(()=>this.move()),...t.map(l=>l.onChange(()=>o.ask())))}pair;clock;element;plots=S("div",{class:"s-curves"});table=S("div",{class:"s-table",tabindex:0,role:"group","aria-label":"Differences"});stops=[];cursor=null;x=()=>0;destroy(){for(let t of this.stops)t()}draw(){let{clock:t,pair:e}=this,n=this.plots.clientWidth;if(!n)return;let s=Math.max(1,n-Ds-pf);this.x=c=>Ds+c/Math.max(t.duration,.001)*s;let r={force:20,performance:20+kh.force+G1},o=r.performance+kh.performance+y0;this.cursor=yt("line",{y1:0,y2:o-y0,stroke:"var(--ink)","stroke-width":1.5});let{times:a}=jc(0,t.duration,Math.max(2,s/90)),l=yt("svg",{width:n,height:o,role:"img","aria-label":"Force and performance of both recordings over time",click:({offsetX:c})=>t.seek((c-Ds)/s*t.duration)},...this.drawForce(r.force,n,Math.round(s)),...this.drawPerformance(r.performance,n),...a.map(c=>mf(this.x(c),o-3,xe(c,0),"middle")),this.cursor);this.plots.replaceChildren(l),this.move(),this.table.replaceChildren($1(W1(...e)))}move(){let t=this.x(this.clock.time).toFixed(1);this.cursor?.setAttribute("x1",t),this.cursor?.setAttribute("x2",t)}drawForce(t,e,n){let{clock:s,pair:r}=this,o=r.map(d=>X1(d,({normal:f})=>f,s.duration,n)),a=o.flat().filter(d=>d!==null),[l,c]=[Math.min(0,...a.map(([d])=>d)),Math.max(5,...a.map(([,d])=>d))],h=d=>t+kh.force*(1-(d-l)/(c-l)),u=o.map((d,f)=>{let p="";return d.forEach((x,m)=>{x&&(p+=`${p&&d[m-1]?"L":"M"}${Ds+m} ${h(x[0]).toFixed(1)}V${h(x[1]).toFixed(1)}`)}),yt("path",{d:p,fill:"none",stroke:w0(f),...b0(f),"data-curve":`force-${Ur[f]}`})});return[...S0("Force [N]",t,e,h,[0,c/2,c].map(Math.round),String),...u]}drawPerformance(t,e){let n=a=>t+kh.performance*(1-a),s=this.pair.flatMap((a,l)=>a.rounds.flatMap(c=>this.drawRound(c,l,n))),o=[...new Set(this.pair.map(({head:a})=>a?.task?.target).filter(a=>a!==void 0))].map(a=>yt("line",{x1:Ds,x2:e-pf,y1:n(a),y2:n(a),stroke:"var(--target)","stroke-dasharray":"6 4"}));return[...S0("Performance [%]",t,e,n,[0,.5,1],a=>String(100*a)),...o,...s]}drawRound({plan:t,start:e,end:n,length:s,interpreted:r,truth:o},a,l){let c=w0(a),h=[];if(t.growth.length){let d=t.growth.map(([f,p])=>`${this.x(e+Math.min(f,s)).toFixed(1)} ${l(p).toFixed(1)}`);h.push(yt("path",{d:`M${d.join("L")}H${this.x(n).toFixed(1)}`,fill:"none",stroke:c,...b0(a),"data-curve":`predicted-${Ur[a]}`}))}let u=this.x(n)-4-9*(1-a);if(r){let{mean:d,low:f,high:p}=r.estimate;h.push(yt("rect",{x:u-3,y:l(p),width:6,height:Math.max(1,l(f)-l(p)),fill:c,"fill-opacity":.3,stroke:c},yt("title",{},`${Ur[a]}: estimated ${Is(r.estimate)}`)),yt("circle",{cx:u,cy:l(d),r:3,fill:c}))}if(typeof o?.performance=="number"){let d=l(o.performance);h.push(yt("path",{d:`M${u-4} ${d-4}l8 8m0 -8l-8 8`,stroke:c,"stroke-width":2,fill:"none"},yt("title",{},`${Ur[a]}: true ${Yt(o.performance)}`)))}return h}};function S0(i,t,e,n,s,r){return[mf(0,t-8,i,"start"),...s.flatMap(o=>[yt("line",{x1:Ds,x2:e-pf,y1:n(o),y2:n(o),stroke:"var(--rule)","stroke-width":.6}),mf(Ds-6,n(o)+4,r(o),"end")])]}function gf(i){return S("i",{class:`s-letter s-letter-${i?"second":"first"}`},Ur[i]??"")}function $1(i){let t=["",...Ur,"B \u2212 A"];return S("table",{},S("thead",{},S("tr",{},...t.map(e=>S("th",{scope:"col"},e)))),S("tbody",{},...i.map(({label:e,texts:n,by:s})=>S("tr",{"data-differs":String(s!==""&&s!==Bn)},S("th",{scope:"row"},e),...n.map(r=>S("td",{title:r},r)),S("td",{},s||"same")))))}var M0=({rounds:i})=>new C(...i[0]?.plan.surface.pose.slice(0,3)??[]);function T0(i){let t=!1,e=i.map(({camera:n,recording:s})=>{let r=()=>{if(!(t||!n)){t=!0;for(let o of i){if(!o.camera||o.camera===n)continue;let a=M0(o.recording).sub(M0(s)),{target:l,eye:c}=n.view;o.camera.followLinked({target:l.add(a),eye:c.add(a)},n.asked)}t=!1}};return n?.controls.addEventListener("change",r),()=>n?.controls.removeEventListener("change",r)});return()=>{for(let n of e)n()}}var vn=class extends Error{constructor(e,n){super(e.message);this.fault=e;this.status=n}fault;status},q1="The studio does not respond. If it has ended, start it again: wisch studio.";async function Gh(i,t){let e;try{e=await fetch(i,{...t,cache:"no-store"})}catch{throw new vn({message:q1},0)}if(e.ok)return e;throw new vn(await Y1(e),e.status)}async function Y1(i){try{let t=await i.json();if(t.error)return t.error}catch{}return{message:`The studio refused the request with HTTP status ${i.status}.`}}var Vh=async(i,t,e)=>await(await Gh(i,{method:"POST",headers:{"content-type":"application/json"},body:JSON.stringify(t),signal:e??null})).json(),E0=async i=>await(await Gh(`api/overview?find=${encodeURIComponent(i)}`)).json(),A0=async()=>await(await Gh("api/vocabulary")).json();async function R0(i,t){let e=await Gh(`api/episodes/${encodeURIComponent(i)}/recording`);try{let n=new TextDecoder,s=e.body.getReader(),r="";for(let o=await s.read();!o.done;o=await s.read()){let a=n.decode(o.value,{stream:!0}),l=a.lastIndexOf(`
`);if(l>=0){for(let c of(r+a.slice(0,l)).split(`
`))t(c);r=""}r+=a.slice(l+1)}t(r+n.decode())}catch{throw new vn({message:"The recording of this episode is damaged: it cannot be decompressed. To list damaged files, run: wisch memory verify."},0)}}var C0=async(i,t,e)=>{let n={task:i,...t===null?{}:{seed:t},...e?{strategy:e}:{}};return(await Vh("api/runs",n)).run},P0=i=>Vh(`api/runs/${encodeURIComponent(i)}/stop`,{}),I0=i=>Vh(`api/runs/${encodeURIComponent(i)}/clear`,{});async function L0(i,t){let e=await Vh("api/ask",{query:i},t);if("error"in e)throw new vn(e.error,200);return e}function xf(i,t){let e=new EventSource("api/overview/events");e.addEventListener("changed",i);let n=!1;e.addEventListener("open",()=>{t(!0),n&&i(),n=!1}),e.addEventListener("error",()=>{n=!0,t(!1),e.readyState===EventSource.CLOSED&&setTimeout(()=>xf(i,t),2e3)})}var Z1=300,Or=class{constructor(t){this.actions=t}actions;element=S("section",{class:"s-stage","aria-label":"Recording"});panes=[];clock=null;stops=[];get shown(){return this.panes}get time(){return this.panes[0]?.view.clock.time??0}say(t,e,...n){this.clear(),this.element.append(S("div",{class:`s-said s-${t}`,role:t==="fault"?"alert":"status"},S("p",{},e),...n))}show(t,e){this.clear();let n=t.length>1;this.element.classList.toggle("s-two",n);let s=n?new Ir:void 0;this.clock=s??null,this.panes=t.map((a,l)=>this.makePane(a,s,l)),s&&this.compare(s);let r=this.panes[0].view.clock;e!==null&&r.seek(e);let o;this.stops.push(r.subscribe(()=>{clearTimeout(o),!(r.playing||r.following)&&(o=setTimeout(()=>this.actions.rests(r.time),Z1))}),()=>clearTimeout(o))}compare(t){let[e,n]=this.panes;if(!e||!n)return;let s=new zh([e.recording,n.recording],[e.id,n.id],t);this.element.append(s.element),this.stops.push(()=>s.destroy(),T0(this.panes.map(({view:{camera:r},recording:o})=>({camera:r,recording:o}))))}makePane(t,e,n){let{recording:s}=t,r=new vf(t,!e,this.actions,h=>a.seek(h));e&&r.element.prepend(gf(n));let o=S("div",{class:"s-view"});this.element.append(S("div",{class:"s-pane"},r.element,r.story,o));let a=_a(o,s,e?{compact:!0,clock:e}:{}),l=0,c=s.onChange(h=>{h?.piece==="samples"||l||(l=requestAnimationFrame(()=>{l=0,r.show()}))});return{...t,view:a,head:r,stop:c}}closeStories(){for(let{head:t}of this.panes)t.toggle(!1)}focus(){let t=this.panes[0]?.view.element;t&&(t.tabIndex=-1,t.focus({preventScroll:!0}))}onConnectionChanged(){for(let{head:t}of this.panes)t.show()}clear(){for(let t of this.stops)t();this.stops=[];for(let{view:t,head:e,stop:n}of this.panes)n(),e.destroy(),t.destroy();this.clock?.destroy(),this.clock=null,this.panes=[],this.element.classList.remove("s-two"),this.element.replaceChildren()}},K1={connecting:"connecting \u2026",live:"live",reconnecting:"connection lost, reconnecting \u2026",ended:"",lost:"the run ended unexpectedly",gone:"the run no longer exists"},vf=class{constructor(t,e,n,s){this.source=t;this.whole=e;this.actions=n;let{recording:r,id:o}=t;this.wasLive=t.live!==null,this.summary=new Nr(r,s),this.story=S("div",{class:"s-story",hidden:!0},this.summary.element),this.stopButton=S("button",{class:"w-button s-stop",type:"button",hidden:!0,click:()=>{this.stopIt(o)}},"Stop"),this.storyButton=S("button",{class:"w-button",type:"button","aria-pressed":"false",click:()=>this.toggle(this.story.hidden)},"Summary"),this.element=S("header",{class:"s-head"},this.title,this.result,this.connection,this.kept,S("span",{class:"s-actions"},this.stopButton,this.storyButton,e&&n.compare&&S("button",{class:"w-button",type:"button",click:()=>n.compare?.()},"Compare"))),this.show()}source;whole;actions;element;story;title=S("h1",{});result=S("span",{class:"s-result"});connection=S("span",{class:"s-connection",role:"status"});kept=S("span",{class:"s-kept w-quiet"});stopButton;storyButton;summary;wasLive;toggle(t){this.story.hidden=!t,this.storyButton.setAttribute("aria-pressed",String(t))}async stopIt(t){this.stopButton.disabled=!0,$t(this.stopButton,"Stopping \u2026");try{await P0(t)}catch(e){this.stopButton.disabled=!1,$t(this.stopButton,"Stop"),$t(this.connection,String(e.message))}}show(){let{recording:t,live:e,id:n}=this.source;$t(this.title,t.head?.title??n);let s=t.rounds.findLast(h=>h.interpreted)?.interpreted,{state:r,text:o}=Dr(t),a=[];if(s){let{mean:h,low:u,high:d}=s.estimate;a.push(S("b",{title:"estimated performance, 90 % interval"},Yt(h),S("small",{},` ${Yt(u)} \u2013 ${Yt(d)}`)))}(t.ended||r==="planned"||r==="logged")&&a.push(S("span",{class:"s-badge","data-state":r},o)),this.result.replaceChildren(...a);let l=e?.connection??"ended";this.connection.dataset.state=l,$t(this.connection,[K1[l],e?.message??""].filter(h=>h).join(": ")),this.stopButton.hidden=!e||l==="ended"||l==="lost"||l==="gone";let c=e?.episode??n;this.title.title=`${this.title.textContent} (${n})`,e&&l==="ended"&&this.kept.replaceChildren(this.actions.isKept(c)?S("a",{href:is({kind:"episode",ids:[c],time:null,query:null}),title:c},"kept as an episode"):"not kept as an episode"),this.wasLive&&t.ended&&(this.wasLive=!1,this.whole&&this.toggle(!0))}destroy(){this.summary.destroy()}};async function J1(i){let t=Uint8Array.from(atob(i),n=>n.charCodeAt(0)),e=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return ti.parse(await new Response(e).text())}var yf=class{constructor(t,e,n,s,r){this.answers=n;this.packed=s;let a=ph(n,{show:(c,h,u)=>{this.show(h,u)},clear:()=>{for(let{view:c}of this.stage.shown)c.clearShown()}});t.classList.add("s-studio"),t.append(S("aside",{class:"s-side s-asked"},S("header",{class:"s-top"},S("h2",{class:"s-name"},"Answers of the memory"),r),S("section",{class:"s-ask"},S("pre",{class:"s-printed"},e),S("div",{class:"s-answers"},...a))),this.stage.element),Object.assign(window,{wisch:{stage:this.stage}});let l=[...ns(n,null),...s.keys()].find(c=>s.has(c));l||fa(n)?this.show(null,l??null):this.stage.say("note","The answers name no episode that the page could show.")}answers;packed;stage=new Or({rests:()=>{},compare:null,isKept:()=>!0});recordings=new Map;asked=0;async show(t,e){let n=++this.asked,s=ns(this.answers,t),r=this.stage.shown.find(({id:l})=>e?l===e:s.includes(l)),o=e??r?.id??s.find(l=>this.packed.has(l))??s[0];if(!o)return;if(!r){let l=this.packed.get(o);if(l===void 0){this.stage.say("note",`This page holds no recording of episode ${o}.`);return}this.stage.say("wait","Loading \u2026");let c=this.recordings.get(o)??J1(l);this.recordings.set(o,c);try{let h=await c;if(n!==this.asked)return;this.stage.show([{id:o,recording:h,live:null}],null)}catch(h){n===this.asked&&this.stage.say("fault",`The recording of episode ${o} cannot be decompressed: ${String(h)}`);return}}let a=this.stage.shown.find(l=>l.id===o);a&&fh(a.view,dh(this.answers,t,o,a.recording))}};function D0(i,t){let e=s=>document.getElementById(s)?.textContent??"",n=new Map([...document.querySelectorAll("script[data-episode]")].map(s=>[s.dataset.episode,s.textContent??""]));new yf(i,e("query"),JSON.parse(e("answers")),n,t)}var j1=12,Q1=/(?:([a-z]+):)?('?)([A-Za-z_][A-Za-z0-9_]*)$/;function tT(i){let t=[],e=new Set;for(let{name:s,arity:r,meaning:o}of i.predicates){let a=/^([^:]*?\)|[^:]*?): /.exec(o)?.[1]??"",l=a.startsWith(`${s}(`)?a:r?`${s}(`:s;e.has(l)||(e.add(l),t.push({name:`${s}/${r}`,kind:"predicate",meaning:o,text:l}))}let n=s=>({name:r,label:o,comment:a})=>({name:r,kind:s,meaning:a||o,text:eT(r)});t.push(...i.classes.map(n("class")),...i.properties.map(n("property")),...i.individuals.map(n("individual")));for(let s of i.builtins)t.push({name:s,kind:"Prolog",meaning:"predicate of standard Prolog",text:s.replace(/\/\d+$/,/\/0$/.test(s)?"":"(")});return t}function eT(i){let[t,e]=i.split(":");return/^[a-z][A-Za-z0-9_]*$/.test(e)?i:`${t}:'${e}'`}function nT(i,t,e){let n=Q1.exec(t.slice(0,e));if(!n||/^[A-Z_]/.test(n[0])&&!n[1]&&!n[2]&&n[0].length<2)return null;let[s,r,,o]=n,a=o.toLowerCase(),l=i.flatMap(h=>{let[u,d]=h.name.includes(":")?h.name.split(":"):["",h.name];if(r&&u!==r)return[];let f=d.toLowerCase().indexOf(a);return f<0?[]:[{proposal:h,place:f?1:0,length:d.length}]});l.sort((h,u)=>h.place-u.place||N0(h.proposal)-N0(u.proposal)||h.length-u.length);let c=l.slice(0,j1).map(({proposal:h})=>h);return c.length?{from:e-s.length,found:c}:null}var N0=({kind:i})=>["predicate","class","property","individual","Prolog"].indexOf(i),Hh=class{constructor(t){this.field=t;t.setAttribute("role","combobox"),t.setAttribute("aria-autocomplete","list"),t.setAttribute("aria-controls","s-proposals"),t.setAttribute("aria-expanded","false"),t.addEventListener("input",()=>this.updateProposals()),t.addEventListener("blur",()=>this.close()),t.addEventListener("keydown",e=>this.onKey(e))}field;list=S("ul",{class:"s-proposals",id:"s-proposals",role:"listbox","aria-label":"Completions",hidden:!0});all=[];now=null;chosen=0;setVocabulary(t){this.all=tT(t)}get isOpen(){return this.now!==null}close(){this.now=null,this.list.hidden=!0,this.field.setAttribute("aria-expanded","false"),this.field.removeAttribute("aria-activedescendant")}updateProposals(){let{value:t,selectionStart:e,selectionEnd:n}=this.field,s=/^[A-Za-z0-9_]/.test(t.slice(e));if(this.now=e===n&&!s?nT(this.all,t,e):null,!this.now)return this.close();this.chosen=0,this.draw()}draw(){let t=this.now.found.map(({name:e,kind:n,meaning:s},r)=>S("li",{id:`s-proposal-${r}`,role:"option","aria-selected":String(r===this.chosen),pointerdown:o=>{o.preventDefault(),this.chosen=r,this.accept()}},S("b",{},e),S("i",{},n),S("span",{},s)));this.list.replaceChildren(...t),this.list.hidden=!1,this.field.setAttribute("aria-expanded","true"),this.field.setAttribute("aria-activedescendant",`s-proposal-${this.chosen}`),t[this.chosen]?.scrollIntoView({block:"nearest"})}onKey(t){if(!this.now)return;let e=this.now.found.length;if(t.key==="ArrowDown")this.chosen=(this.chosen+1)%e;else if(t.key==="ArrowUp")this.chosen=(this.chosen+e-1)%e;else return t.key==="Tab"?this.accept(t):t.key==="Escape"?(t.preventDefault(),t.stopPropagation(),this.close()):void 0;t.preventDefault(),this.draw()}accept(t){t?.preventDefault();let{from:e,found:n}=this.now,{text:s}=n[this.chosen],{value:r,selectionStart:o}=this.field;this.field.setRangeText(s,e,o,"end");let a=this.field.selectionStart,l=r.slice(o);s.endsWith("(")&&l.startsWith("(")&&this.field.setRangeText("",a-1,a,"end"),this.close()}};var Wh=class{constructor(t){this.actions=t;this.button=S("button",{class:"w-button s-primary",type:"button",click:()=>this.asking?this.asking.abort():void this.ask()},"Ask"),this.element=S("section",{class:"s-ask",hidden:!0},S("div",{class:"s-field"},this.field,this.completer.list),S("div",{class:"s-row"},this.button,S("span",{class:"w-quiet"},"Enter: ask; Shift + Enter: new line; Tab: complete")),this.fault,this.examples,this.result),this.field.addEventListener("input",()=>{this.fault.hidden=!0}),this.loadVocabulary()}actions;element;field=S("textarea",{class:"s-query",rows:3,spellcheck:"false",autocomplete:"off","aria-label":"Query in Prolog",placeholder:"low_performance_round(Round, P)",keydown:t=>{t.key!=="Enter"||t.shiftKey||t.isComposing||(t.preventDefault(),this.ask())}});completer=new Hh(this.field);fault=S("div",{class:"w-complaint s-fault",role:"alert",hidden:!0});chips=S("div",{class:"s-chips"});examples=S("details",{class:"s-examples",open:!0},S("summary",{},S("h2",{},"Example questions")),this.chips);result=S("div",{class:"s-answers","aria-live":"polite"});button;asking=null;async loadVocabulary(){try{let t=await A0();this.completer.setVocabulary(t),this.chips.replaceChildren(...t.examples.map(({title:e,query:n},s)=>S("button",{class:"s-chip",type:"button",title:n,"data-example":s,click:()=>{this.field.value=n,this.ask()}},e)))}catch(t){this.complain({message:t.message})}}propose(t){this.asking?.abort(),this.asking=null,$t(this.button,"Ask"),this.completer.close(),this.field.value=t,this.fault.hidden=!0,this.examples.open=!1,this.actions.clear(),this.result.replaceChildren(S("p",{class:"s-remark"},"This query comes from the page's address. Press Ask to run it."))}async ask(){let t=this.field.value.trim();if(!t||this.asking)return;this.completer.close(),this.fault.hidden=!0;let e=new AbortController;this.asking=e,this.examples.open=!1,$t(this.button,"Cancel"),this.result.replaceChildren(S("p",{class:"w-quiet"},"Asking \u2026")),this.actions.asked(t);try{let n=await L0(t,e.signal);this.result.replaceChildren(...ph(n,this.actions)),fa(n)?this.actions.show(n,null,null):this.actions.clear()}catch(n){if(this.asking!==e)return;this.result.replaceChildren(),e.signal.aborted||this.complain(n instanceof vn?n.fault:{message:String(n)})}finally{this.asking===e&&(this.asking=null,$t(this.button,"Ask"))}}complain({message:t,offset:e,length:n,line:s,column:r}){let o=this.field.value.trim(),a=[S("p",{},t)];if(e!==void 0&&n!==void 0){let l=e+n;a.push(S("pre",{},o.slice(0,e),S("mark",{},o.slice(e,l)||"\u2038"),o.slice(l))),o.includes(`
`)&&a.push(S("p",{class:"w-quiet"},`line ${s}, column ${r}`)),this.field.value=o,document.activeElement===this.field&&this.field.setSelectionRange(e,l)}this.fault.replaceChildren(...a),this.fault.hidden=!1}};var iT=200,Xh=class{constructor(t){this.actions=t;let e;this.search=S("input",{class:"s-search",type:"search",placeholder:"Search episodes","aria-label":"Search episodes",autocomplete:"off",input:()=>{clearTimeout(e),e=setTimeout(()=>t.find(this.words),iT)}}),this.element=S("section",{class:"s-runs"},S("button",{class:"w-button s-primary",type:"button",click:()=>t.start()},"Start a task"),this.search,this.note,this.list,this.where)}actions;element;list=S("div",{class:"s-list"});search;where=S("p",{class:"s-where w-quiet"});note=S("div",{class:"s-picking",hidden:!0,role:"status"});overview=null;current=[];picking=null;drawn="";get words(){return this.search.value.trim()}show(t){this.overview=t,this.draw()}mark(t){this.current=t,this.draw()}compareWith(t){this.picking=t,this.note.hidden=!t,this.note.replaceChildren(...t?[S("p",{},"Choose a run or episode to compare with."),S("button",{class:"w-button",type:"button",click:()=>this.compareWith(null)},"Cancel")]:[])}draw(){if(!this.overview)return;let{list:t,runs:e,memory:n}=this.overview,s=JSON.stringify([t,e,this.current]);if(s===this.drawn)return;this.drawn=s;let r=document.activeElement?.dataset.key,o=[],a=e.filter(({state:l})=>l!=="ended");a.length&&o.push(S("h2",{},"Now"),S("ul",{},...a.map(l=>this.makeRun(l))));for(let[l,c]of oT(t.episodes))o.push(S("h2",{},l),S("ul",{},...c.map(h=>this.makeEpisode(h))));!t.episodes.length&&(this.words||!a.length)&&o.push(S("p",{class:"w-quiet"},this.words?"No matching episodes.":"There are no episodes yet. Start a task.")),t.total>t.episodes.length&&o.push(S("p",{class:"w-quiet"},`The list shows the newest ${t.episodes.length} of ${t.total} episodes. Use the search for older ones.`)),t.broken.length&&o.push(S("details",{class:"s-broken"},S("summary",{},`${t.broken.length} unreadable ${t.broken.length===1?"episode":"episodes"}`),...t.broken.map(l=>S("p",{},l)))),this.list.replaceChildren(...o),$t(this.where,`Memory: ${n}`),r&&this.list.querySelector(`[data-key="${CSS.escape(r)}"]`)?.focus()}makeLink(t,e,...n){let s=this.current.includes(e);return S("a",{href:is({kind:t,ids:[e],time:null,query:null}),"data-key":e,"aria-current":s?"true":null,click:r=>{!this.picking||r.ctrlKey||r.metaKey||r.shiftKey||(r.preventDefault(),this.actions.pick(e))}},...n)}makeRun({id:t,task:e,begun:n,state:s,message:r}){let o=s==="lost",a=o?"ended unexpectedly":`running${n?` since ${rT(n)}`:""}`;return S("li",{},this.makeLink("run",t,S("span",{class:"s-title"},S("i",{class:`s-dot${o?" s-dot-lost":""}`,"aria-hidden":"true"}),e),S("span",{class:"s-what"},S("span",{},a)),o&&r?S("span",{class:"s-what s-bad"},r):null),o&&S("button",{class:"w-button s-clear",type:"button",title:"Remove from the list","aria-label":`Remove ${e} from the list`,click:()=>{I0(t).catch(()=>{})}},"\xD7"))}makeEpisode(t){let{performance:e,low:n,high:s,rounds:r,collisions:o}=t,a=[U0(new Date(1e3*t.begun)),`${r} ${r===1?"round":"rounds"}`,`${me(t.seconds,0)} s`];o&&a.push(`${o} ${o===1?"push":"pushes"}`),t.has_recording||a.push("no recording");let l=n!==null&&s!==null?`, 90\u202F% interval ${Yt(n)} to ${Yt(s)}`:"";return S("li",{},this.makeLink("episode",t.id,S("span",{class:"s-title"},S("span",{},t.title),e===null?null:S("b",{title:`estimated performance${l}`},Yt(e)),sT(t)),S("span",{class:"s-what"},a.join(" \xB7 "))))}};function sT({met:i,verdict:t,performance:e}){let n=nf(i,t),s=n==="unmet"&&e===null?"none":n;return S("span",{class:"s-badge","data-state":s,title:t??""},{met:"met",unmet:"not met",unknown:"unknown",none:"\u2013"}[s])}var U0=i=>i.toLocaleTimeString([],{hour:"2-digit",minute:"2-digit"});function rT(i){let t=new Date(`${i.replace(" ","T").replace(/Z$/,"")}Z`);return Number.isNaN(t.getTime())?i:U0(t)}function oT(i){let t=new Map,e=s=>s.toLocaleDateString([],{weekday:"short",year:"numeric",month:"short",day:"numeric"}),n=e(new Date);for(let s of i){let r=e(new Date(1e3*s.begun));r===n&&(r="Today"),t.set(r,[...t.get(r)??[],s])}return t}var aT=4,lT=1e3,Fr=new Map;async function O0(i){let t=Fr.get(i);Fr.delete(i);let e=t??await cT(i);return F0(i,e),e}async function cT(i){let t=new ti;return await R0(i,e=>t.applyLine(e)),t.close(),t}function F0(i,t){Fr.set(i,t);let[e]=Fr.keys();Fr.size>aT&&e!==void 0&&Fr.delete(e)}var $h=class{constructor(t,e){this.id=t;this.changed=e;this.open()}id;changed;recording=new ti;connection="connecting";message="";lines=0;events=null;later;failures=0;open(){let t=new EventSource(`api/runs/${encodeURIComponent(this.id)}/stream?after=${this.lines}`);this.events=t,t.addEventListener("open",()=>{this.failures=0,this.set("live")}),t.addEventListener("message",({data:e,lastEventId:n})=>{let s=Number(n);s<=this.lines||(this.lines=s,this.recording.applyLine(e))}),t.addEventListener("end",({data:e})=>this.end(e)),t.addEventListener("error",()=>{if(this.set("reconnecting"),t.readyState===EventSource.CLOSED){if(this.failures++,this.failures>3){this.recording.close(),this.set("gone");return}this.later=setTimeout(()=>this.open(),lT*this.failures)}})}end(t){this.close();let e=JSON.parse(t);this.message=e.message,this.recording.close();let n=e.state==="ended";n&&this.recording.ended&&F0(this.episode,this.recording),this.set(n?"ended":"lost")}get episode(){return this.recording.ended?.episode??this.id}set(t){this.connection=t,this.changed()}close(){clearTimeout(this.later),this.events?.close(),this.events=null}};var hT=["best","adaptive","grid","rrt","kde"],qh=class{constructor(t){this.begun=t;let e=S("form",{class:"s-own",submit:n=>{n.preventDefault(),this.start(this.path.value.trim())}},S("label",{},"Your own task file",this.path),S("button",{class:"w-button",type:"submit"},"Start"));this.element=S("dialog",{class:"s-dialog","aria-labelledby":"s-start-title"},S("header",{},S("h1",{id:"s-start-title"},"Start a task"),S("button",{class:"w-button",type:"button","aria-label":"Close",click:()=>this.element.close()},"\xD7")),this.fault,this.list,e,S("div",{class:"s-options"},S("label",{},"Seed",this.seed),S("label",{},"Strategy",this.strategy))),this.list.append(S("li",{},"Loading \u2026")),this.element.addEventListener("click",n=>{n.target===this.element&&this.element.close()}),this.element.addEventListener("input",()=>{this.fault.hidden=!0})}begun;element;list=S("ul",{class:"s-scenarios"});seed=S("input",{type:"number",min:0,step:1,placeholder:"from the task","aria-label":"Seed"});strategy=S("select",{class:"w-select","aria-label":"Strategy"},S("option",{value:""},"from the task"),...hT.map(t=>S("option",{value:t},t)));path=S("input",{type:"text",placeholder:"/path/to/task.toml","aria-label":"Task file on this machine",autocomplete:"off",spellcheck:"false"});fault=S("p",{class:"w-complaint",role:"alert",hidden:!0});busy=!1;known="";open(){this.fault.hidden=!0,this.element.showModal()}setScenarios(t){let e=JSON.stringify(t);e!==this.known&&(this.known=e,this.list.replaceChildren(...t.map(({name:n,about:s})=>S("li",{},S("div",{},S("b",{},n),S("p",{},s)),S("button",{class:"w-button s-primary",type:"button","data-task":n,"aria-label":`Start ${n}`,click:()=>{this.start(n)}},"Start")))),t.length||this.list.append(S("li",{},"No shipped tasks were found.")))}async start(t){if(this.busy)return;let e=this.seed.value.trim();if(!t)return this.complain("The path is empty. Enter the path of a task file.");if(e&&!/^\d+$/.test(e))return this.complain("The seed must be a whole number, 0 or greater.");this.fault.hidden=!0,this.setBusy(!0);try{let n=await C0(t,e?Number(e):null,this.strategy.value||null);this.element.close(),this.begun(n)}catch(n){this.complain(n instanceof vn?n.message:String(n))}finally{this.setBusy(!1)}}setBusy(t){this.busy=t,this.element.toggleAttribute("data-busy",t);for(let e of this.element.querySelectorAll("button"))e.disabled=t}complain(t){this.fault.hidden=!1,$t(this.fault,t),this.fault.scrollIntoView({block:"nearest"})}};var wa={kind:"home",ids:[],time:null,query:null},_f=class{side;stage;ask;dialog;tabs;offline=S("p",{class:"s-offline",role:"status",hidden:!0},"The studio does not respond. If it has ended, start it again: wisch studio.");aside;known=null;place=wa;live=[];opened=0;constructor(t,e){this.side=new Xh({find:()=>{this.refresh()},start:()=>this.dialog.open(),pick:s=>this.compare(s)}),this.ask=new Wh({show:(s,r,o)=>{this.show(s,r,o)},clear:()=>{for(let{view:s}of this.stage.shown)s.clearShown()},asked:s=>this.keep({query:s})}),this.stage=new Or({rests:s=>this.keep({time:s}),compare:()=>{this.open("runs"),this.side.compareWith(this.place.ids[0]??null)},isKept:s=>this.isKept(s)}),this.dialog=new qh(s=>{this.go({...wa,kind:"run",ids:[s]}).then(()=>this.stage.focus())});let n=(s,r,o)=>S("button",{class:"w-button",type:"button","aria-pressed":"false",title:o,click:()=>this.isNarrow&&this.aside.dataset.open===s?this.open(null):this.open(s)},r);this.tabs={runs:n("runs","Runs","Runs and episodes"),ask:n("ask","Ask","Ask the memory ( / )")},this.aside=S("aside",{class:"s-side"},S("header",{class:"s-top"},S("h2",{class:"s-name"},"wisch studio"),this.tabs.runs,this.tabs.ask,e),this.offline,this.side.element,this.ask.element),t.classList.add("s-studio"),t.append(this.aside,this.stage.element,this.dialog.element),this.open("runs")}async begin(){addEventListener("hashchange",()=>{this.route()}),document.addEventListener("keydown",e=>{let n=e.target;e.key!=="/"||e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|TEXTAREA|SELECT)$/.test(n.tagName)||(e.preventDefault(),this.open("ask"),this.ask.field.focus())}),xf(()=>{this.refresh()},e=>{this.offline.hidden=e}),Object.assign(window,{wisch:{studio:this,stage:this.stage}});let t=this.refresh();ff(location.hash).kind!=="episode"&&await t,await this.route()}get isNarrow(){return matchMedia("(max-width: 760px)").matches}open(t){this.aside.dataset.open=t??"",this.side.element.hidden=t!=="runs",this.ask.element.hidden=t!=="ask";for(let e of["runs","ask"])this.tabs[e].setAttribute("aria-pressed",String(t===e))}async refresh(){try{this.known=await E0(this.side.words),this.side.show(this.known),this.dialog.setScenarios(this.known.scenarios),this.stage.onConnectionChanged()}catch(t){this.known||this.stage.say("fault",t.message)}}isKept(t){return this.known?.list.episodes.some(e=>e.id===t)??!1}async go(t){history.pushState(null,"",is(t)||location.pathname),await this.route()}keep(t){this.place={...this.place,...t},v0(this.place)}async route(){let t=ff(location.hash),{query:e}=t;t.kind==="home"&&(t={...this.first(),query:e});let n=this.place;this.place=t,!x0(n,t)||!this.stage.shown.length?await this.load(t):t.time!==null&&Math.abs(t.time-this.stage.time)>.06&&this.stage.shown[0].view.seek(t.time),e&&e!==n.query&&(this.open("ask"),this.ask.propose(e))}first(){let t=this.known?.runs.find(({state:n})=>n==="running");if(t)return{...wa,kind:"run",ids:[t.id]};let e=this.known?.list.episodes.find(({has_recording:n})=>n);return e?{...wa,kind:"episode",ids:[e.id]}:wa}async load(t){let e=++this.opened;for(let n of this.live)n.close();if(this.live=[],this.side.compareWith(null),this.side.mark(t.ids),this.isNarrow&&t.kind!=="home"&&this.open(null),t.kind==="home"){this.stage.say("note","This memory has no runs yet.",S("button",{class:"w-button s-primary",type:"button",click:()=>this.dialog.open()},"Start a task"));return}this.stage.say("wait","Loading \u2026");try{let n=[];for(let s of t.ids)n.push(await this.source(s,t.kind==="run"));if(e!==this.opened)return;this.stage.show(n,t.time),document.title=`${n.map(({id:s,recording:r})=>r.head?.title??s).join(" | ")} \u2013 wisch studio`}catch(n){if(e!==this.opened)return;let s=n instanceof vn?n.message:`The recording cannot be shown: ${String(n)}`;this.stage.say("fault",s,S("p",{class:"w-quiet"},"Queries about this episode still work."))}}async source(t,e){if(e&&!this.isRun(t)&&await this.refresh(),this.isRun(t))return this.liveSource(t);try{return{id:t,recording:await O0(t),live:null}}catch(n){if(!(n instanceof vn)||n.status!==404)throw n;if(await this.refresh(),this.isRun(t))return this.liveSource(t);throw this.known&&!this.isKept(t)?new vn({message:`There is no run or episode ${t}. A run that is stopped before its first motion is not kept.`},404):n}}isRun(t){return this.known?.runs.some(e=>e.id===t)??!1}liveSource(t){let e=new $h(t,()=>this.liveChanged(e));return this.live.push(e),{id:t,recording:e.recording,live:e}}liveChanged(t){this.stage.onConnectionChanged(),t.connection==="ended"&&this.refresh().then(()=>{this.place.kind!=="run"||this.place.ids[0]!==t.id||!this.isKept(t.episode)||(this.keep({kind:"episode",ids:[t.episode]}),this.side.mark(this.place.ids))})}compare(t){let e=this.place.ids[0];this.side.compareWith(null),!(!e||e===t)&&this.go({kind:"compare",ids:[e,t],time:this.stage.time,query:null})}async show(t,e,n){let s=ns(t,e),r=this.stage.shown.find(({id:l})=>n?l===n:s.includes(l)),o=n??r?.id??s[0];if(!o)return;if(r)this.isNarrow&&this.open(null);else{let l={kind:"episode",ids:[o],time:null,query:this.place.query};history.pushState(null,"",is(l)),this.place=l,await this.load(l)}let a=this.stage.shown.find(l=>l.id===o);a&&(this.stage.closeStories(),fh(a.view,dh(t,e,o,a.recording)))}};function k0(i,t){new _f(i,t).begin()}function bf(){let i=S("button",{class:"w-button w-theme",type:"button",click:()=>jm(ws()==="dark"?"light":"dark")}),t=()=>$t(i,ws()==="dark"?"Light":"Dark");return wr(t),t(),i}var z0=i=>{let t=/^#t=(\d+(?:\.\d+)?)$/.exec(i);return t?Number(t[1]):null};function uT({clock:i}){let t;i.subscribe(()=>{clearTimeout(t),!(i.playing||i.following)&&(t=setTimeout(()=>{let e=`#t=${i.time.toFixed(1)}`;if(!(location.hash===e||!location.hash&&i.time===0))try{history.replaceState(null,"",e)}catch{}},300))}),addEventListener("hashchange",()=>{let e=z0(location.hash);e!==null&&Math.abs(e-i.time)>.06&&i.seek(e)})}function dT(i){let t=ti.parse(document.getElementById("recording")?.textContent??"");i.classList.add("w-report");let e=new Nr(t,s=>{n.seek(s),n.element.scrollIntoView({block:"start"})},bf());i.append(e.element);let n=_a(i,t);n.seek(z0(location.hash)??0),uT(n),Object.assign(window,{wisch:{recording:t,view:n,Recording:ti,mountView:_a}})}Qm();var kr=document.getElementById("app"),{page:B0}=document.documentElement.dataset;kr&&B0==="report"?dT(kr):kr&&B0==="answers"?D0(kr,bf()):kr&&k0(kr,bf());})();
